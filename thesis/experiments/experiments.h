/// \file
/// The functions behind the table of experiments, one file each (or one for those of a kind).
#pragma once

#include "thesis/run/experiment.h"

namespace soms::reproduce {

/// Claims that are counts: the sizes of the models, that SOMS needs no fallback, more leaves with
/// one triangle, 26 % more of them, a more balanced tree, the balanced level 7 of the urban scene.
/// \source  thesis, abstract, chapter 1, figures 4.2 and 5.5, tables 5.3 and 5.9.
[[nodiscard]] Result claim_models(const Context& context);
[[nodiscard]] Result claim_fallback(const Context& context);
[[nodiscard]] Result claim_single_leaves(const Context& context);
[[nodiscard]] Result claim_26_percent(const Context& context);
[[nodiscard]] Result claim_balance(const Context& context);
[[nodiscard]] Result claim_level_7(const Context& context);

/// Premises of the thesis: a balanced tree is traversed faster; a tree by SOMS is cheaper to query.
/// \source thesis, abstract and chapter 1.
[[nodiscard]] Result claim_balanced(const Context& context);
[[nodiscard]] Result claim_cheaper(const Context& context);

/// Claims on build times: SOMS against spatial median by the library's builder and by two neutral
/// ones. \source thesis, abstract; chapter 1; captions of figures 5.4, 5.5 and table 5.8.
[[nodiscard]] Result claim_build_8_percent(const Context& context);
[[nodiscard]] Result claim_build_43_ms(const Context& context);
[[nodiscard]] Result claim_build_city(const Context& context);

/// The claims about E-Node: that it is faster and detects overlaps earlier than Larsson's
/// traversal, and in 0.2 ms. \source thesis, abstract, section 5.5 and figure 5.10.
[[nodiscard]] Result claim_enode_faster(const Context& context);
[[nodiscard]] Result claim_enode_earlier(const Context& context);
[[nodiscard]] Result claim_enode_time(const Context& context);

/// Objects and urban scenes: what their files hold. \source thesis, tables 3.1 and 3.3.
[[nodiscard]] Result table_3_1(const Context& context);
[[nodiscard]] Result table_3_3(const Context& context);

/// The testing procedure: which items are which step. \source thesis, figure 5.1.
[[nodiscard]] Result figure_5_1(const Context& context);

/// Build times of all builds of a model at one level: the objects at the balanced level of spatial
/// median and of SOMS, the urban scenes at that of spatial median and at level 7; the time for a
/// node at the greatest level; the urban scenes at level 12.
/// \source  thesis, figures 5.2 to 5.5, tables 5.1, 5.6 and 5.8.
[[nodiscard]] Result figure_5_2(const Context& context);
[[nodiscard]] Result figure_5_3(const Context& context);
[[nodiscard]] Result table_5_1(const Context& context);
[[nodiscard]] Result figure_5_4(const Context& context);
[[nodiscard]] Result figure_5_5(const Context& context);
[[nodiscard]] Result table_5_6(const Context& context);
[[nodiscard]] Result table_5_8(const Context& context);

/// Share of the build time by level, objects and urban scenes. \source thesis, tables 5.2 and 5.7.
[[nodiscard]] Result table_5_2(const Context& context);
[[nodiscard]] Result table_5_7(const Context& context);

/// Nodes with one triangle, objects and urban scenes. \source thesis, tables 5.3 and 5.9.
[[nodiscard]] Result table_5_3(const Context& context);
[[nodiscard]] Result table_5_9(const Context& context);

/// Leaves with fewer than five triangles. \source thesis, tables 5.4 and 5.10.
[[nodiscard]] Result table_5_4(const Context& context);
[[nodiscard]] Result table_5_10(const Context& context);

/// Nodes that cannot be divided. \source thesis, tables 5.5 and 5.11.
[[nodiscard]] Result table_5_5(const Context& context);
[[nodiscard]] Result table_5_11(const Context& context);

/// The effect of each option that the thesis leaves open, on the first object and the scenes.
[[nodiscard]] Result options(const Context& context);

/// Other readings of the rule, and what speaks against them. \source thesis, abstract,
/// figures 4.6, 4.23.
[[nodiscard]] Result readings(const Context& context);

/// Other readings of E-Node, what speaks for and against them, and what each does and gets wrong.
/// \source thesis, section 5.5 by its headings, abstract, section 1.2, research question 7.
[[nodiscard]] Result readings_e_node(const Context& context);

/// Which rule balances best, on objects and scenes. \source thesis, abstract.
[[nodiscard]] Result balance(const Context& context);

/// The orientation tests: axis and direction of each. \source thesis, table 3.2.
[[nodiscard]] Result table_3_2(const Context& context);

/// The objects, drawn. \source thesis, figure 3.7.
[[nodiscard]] Result figure_3_7(const Context& context);

/// The object and from where its like comes at it. \source thesis, figure 3.8.
[[nodiscard]] Result figure_3_8(const Context& context);

/// The urban scenes beside the object that moves through them. \source thesis, figure 3.9.
[[nodiscard]] Result figure_3_9(const Context& context);

/// Small sets: the planes of the common rules, levels of trees, where spatial median fails, the
/// boxes that count, SOMS in pseudo code, its plane, and all rules in space.
/// \source  thesis, figures 4.1 to 4.7.
[[nodiscard]] Result figure_4_1(const Context& context);
[[nodiscard]] Result figure_4_2(const Context& context);
[[nodiscard]] Result figure_4_3(const Context& context);
[[nodiscard]] Result figure_4_4(const Context& context);
[[nodiscard]] Result figure_4_5(const Context& context);
[[nodiscard]] Result figure_4_6(const Context& context);
[[nodiscard]] Result figure_4_7(const Context& context);

/// Boxes: how one is found and follows its set, its corners and their numbers, how it is drawn.
/// \source  thesis, figures 4.8 to 4.13, by their captions.
[[nodiscard]] Result figure_4_8(const Context& context);
[[nodiscard]] Result figure_4_9(const Context& context);
[[nodiscard]] Result figure_4_10(const Context& context);
[[nodiscard]] Result figure_4_11(const Context& context);
[[nodiscard]] Result figure_4_12(const Context& context);
[[nodiscard]] Result figure_4_13(const Context& context);

/// The tree as a class, what TreeIDs tell, how nodes come to be, and which axis is divided.
/// \source  thesis, figures 4.14 to 4.22, by their captions.
[[nodiscard]] Result figure_4_14(const Context& context);
[[nodiscard]] Result figure_4_15(const Context& context);
[[nodiscard]] Result figure_4_16(const Context& context);
[[nodiscard]] Result figure_4_17(const Context& context);
[[nodiscard]] Result figure_4_18(const Context& context);
[[nodiscard]] Result figure_4_19(const Context& context);
[[nodiscard]] Result figure_4_20(const Context& context);
[[nodiscard]] Result figure_4_21(const Context& context);
[[nodiscard]] Result figure_4_22(const Context& context);

/// The center of a triangle, and how the triangles of a node are divided and stored: small sets.
/// \source  thesis, figures 4.23 to 4.26.
[[nodiscard]] Result figure_4_23(const Context& context);
[[nodiscard]] Result figure_4_24(const Context& context);
[[nodiscard]] Result figure_4_25(const Context& context);
[[nodiscard]] Result figure_4_26(const Context& context);

/// Triangles by TreeID, a tree divided node by node, and how a level of a tree is drawn.
/// \source  thesis, figures 4.27 to 4.29.
[[nodiscard]] Result figure_4_27(const Context& context);
[[nodiscard]] Result figure_4_28(const Context& context);
[[nodiscard]] Result figure_4_29(const Context& context);

/// The bunny's tree at levels 1, 3, 5 and 6, for each rule. \source thesis, figure 4.30.
[[nodiscard]] Result figure_4_30(const Context& context);

/// Traversals in pseudo code, each beside a run; is a node internal.
/// \source  thesis, figures 4.31, 4.34, 4.36 and 4.37.
[[nodiscard]] Result figure_4_31(const Context& context);
[[nodiscard]] Result figure_4_34(const Context& context);
[[nodiscard]] Result figure_4_36(const Context& context);
[[nodiscard]] Result figure_4_37(const Context& context);

/// The test of the roots frame by frame, and that of two boxes axis by axis.
/// \source  thesis, figures 4.32 and 4.33.
[[nodiscard]] Result figure_4_32(const Context& context);
[[nodiscard]] Result figure_4_33(const Context& context);

/// What pruning saves, in counts and as a picture. \source thesis, figure 4.35.
[[nodiscard]] Result figure_4_35(const Context& context);

/// The first quarter of the city, object by object and in the whole.
/// \source  thesis, figures 4.39 and 4.40.
[[nodiscard]] Result figure_4_39(const Context& context);
[[nodiscard]] Result figure_4_40(const Context& context);

/// The city whole and as it is loaded, its way through a 3DS file, and its tree level by level.
/// \source  thesis, figures 4.41 to 4.44.
[[nodiscard]] Result figure_4_41(const Context& context);
[[nodiscard]] Result figure_4_42(const Context& context);
[[nodiscard]] Result figure_4_43(const Context& context);
[[nodiscard]] Result figure_4_44(const Context& context);

/// The tests right, left and top by the generic traversal, frame by frame. \source thesis, figures
/// 5.6, 5.7 and 5.8.
[[nodiscard]] Result figure_5_6(const Context& context);
[[nodiscard]] Result figure_5_7(const Context& context);
[[nodiscard]] Result figure_5_8(const Context& context);

/// E-Node explained step by step. \source thesis, figure 5.9.
[[nodiscard]] Result figure_5_9(const Context& context);

/// E-Node against the traversal after Larsson. \source thesis, figure 5.10.
[[nodiscard]] Result figure_5_10(const Context& context);

/// What of the thesis is shown; where options come from. \source thesis, lists of tables and
/// figures.
[[nodiscard]] Result coverage(const Context& context);
[[nodiscard]] Result sources(const Context& context);

/// The tests from the sides of which the thesis has no figure, as figures 5.6 to 5.8.
[[nodiscard]] Result orientation_bottom(const Context& context);
[[nodiscard]] Result orientation_front(const Context& context);
[[nodiscard]] Result orientation_back(const Context& context);

/// Every traversal of two trees on the orientation tests and the city drives.
[[nodiscard]] Result traversals(const Context& context);

/// Drives through the scenes: frames in which triangles touch apart from those in which none do.
[[nodiscard]] Result drives(const Context& context);

/// The drives as the viewer draws them, beside the same without drawing.
[[nodiscard]] Result drives_drawn(const Context& context);

/// The thesis' models and scenes by modern measures: SAH cost, expected and measured visits,
/// memory, build rate, exact queries; every rule with the thesis' options and with the product's.
[[nodiscard]] Result modern(const Context& context);

/// The same on real cities; on a generated one where none is given.
[[nodiscard]] Result cities(const Context& context);

/// Rules against the spread of triangle sizes, in a scene where nothing else changes.
[[nodiscard]] Result spread(const Context& context);

}  // namespace soms::reproduce
