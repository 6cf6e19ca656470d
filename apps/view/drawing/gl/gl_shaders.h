/// \file
/// The shaders, in GLSL 3.30. Private to the renderer.
///
/// Positions are relative to the eye ("device coordinates" of gl_view.h). Names shared by all:
/// `clip` takes them to the clip space, `lift` brings overlays nearer, `nearest` is the least w.
#pragma once

namespace soms::view::shader {

extern const char* const kLightHead;  ///< stands before the fragment shaders that shade
extern const char* const kSurfaceVertex;
extern const char* const kSurfaceFragment;

extern const char* const kGroundVertex;
extern const char* const kGroundFragment;

extern const char* const kShadowFragment;  ///< depths alone; with kSurfaceVertex

extern const char* const kBoxVertex;  ///< faces of boxes; with kSurfaceFragment

extern const char* const kStrokeHead;  ///< stands before the next two
extern const char* const kLineVertex;
extern const char* const kEdgeVertex;  ///< twelve edges a box
extern const char* const kStrokeFragment;
extern const char* const kLineFragment;  ///< with a rim on either side

extern const char* const kPointVertex;
extern const char* const kPointFragment;

extern const char* const kLetterVertex;  ///< strokes of letters, in pixels
extern const char* const kLetterFragment;

extern const char* const kBackgroundVertex;
extern const char* const kBackgroundFragment;

extern const char* const
    kPlaceHead;  ///< places from depths; stands before the next fragment shaders
extern const char* const
    kAmbientFragment;                    ///< share of the sky that is seen; with kBackgroundVertex
extern const char* const kGlowVertex;    ///< a box about a segment
extern const char* const kGlowFragment;  ///< nearness of surfaces to it
/// Darkens surfaces by what hides the sky and colors them about contacts; with kBackgroundVertex.
extern const char* const kFinishFragment;

}  // namespace soms::view::shader
