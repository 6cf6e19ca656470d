/// \file
/// How the page of a list of parts looks, beyond what page_style.h says.
#pragma once

#include <string_view>

namespace soms::report {

inline constexpr std::string_view kPartsStyle = R"css(
#look{grid-template-columns:minmax(0,1fr) 22rem}
#filters,#pair-filter,#count,#table,#table+.note{grid-column:1/-1}
#filters{display:flex;flex-wrap:wrap;gap:.4rem .8rem;align-items:center}
#filters #find{flex:1 1 18rem}
#filters fieldset{border:1px solid var(--line);border-radius:.35rem;margin:0;padding:.1rem .5rem .25rem;display:flex;flex-wrap:wrap;
gap:.1rem .8rem;font-size:.9rem}
#filters legend{color:var(--faint);font-size:.8rem}
#filters label.none{color:var(--faint)}
#pair-filter{margin:0}#table+.note{margin:0}
#table{height:min(30rem,60vh);min-height:14rem;overflow:auto;border:1px solid var(--line);border-radius:.4rem;position:relative}
#table:focus-visible{outline:3px solid var(--link);outline-offset:-3px}
#head{position:sticky;top:0;z-index:1;display:grid;background:var(--paper);border-bottom:2px solid var(--line);min-width:60rem}
#head [role=columnheader]{min-width:0}
#look #head button{width:100%;min-height:2rem;border:0;border-radius:0;text-align:left;font-weight:600;padding:.2rem .4rem;overflow:hidden;
text-overflow:ellipsis;white-space:nowrap}
#head [aria-sort=ascending] button::after{content:" \25b4"}#head [aria-sort=descending] button::after{content:" \25be"}
#rows{position:relative;min-width:60rem}
.clash{position:absolute;left:0;right:0;height:40px;display:grid;align-items:center;border-bottom:1px solid var(--line);cursor:pointer;
font-size:.88rem;line-height:1.2}
.clash:hover{background:var(--soft)}
.clash[aria-selected=true]{background:var(--soft);box-shadow:inset 0 0 0 2px var(--link)}
.clash>span{padding:0 .4rem;min-width:0;overflow:hidden;text-overflow:ellipsis;display:-webkit-box;-webkit-line-clamp:2;
-webkit-box-orient:vertical;overflow-wrap:anywhere}
.clash>.number,#head .number button{text-align:right!important;font-variant-numeric:tabular-nums}
#stage{height:min(34rem,64vh)}
#side{height:min(34rem,64vh);overflow-y:auto;display:block}
#side h3{margin:0 0 .5rem;overflow-wrap:anywhere}
#details{display:grid;grid-template-columns:max-content minmax(0,1fr);gap:.15rem .7rem;margin:0;font-size:.9rem}
#details dt{color:var(--faint)}#details dd{margin:0;overflow-wrap:anywhere;user-select:text}
#tools label{background:var(--paper);border:1px solid var(--faint);border-radius:.35rem;padding:.25rem .6rem}
.key.rest{background:var(--ground);border:1px solid var(--faint)}
#matrices table{margin:.5rem 0 1rem}
#matrices th{max-width:14rem;overflow-wrap:anywhere}
#matrices td button{font:inherit;color:var(--link);background:none;border:0;padding:0;cursor:pointer;text-decoration:underline}
#matrices td.number{min-width:4rem}#matrices .picture{overflow-x:auto}
#printed{width:100%;font-size:.72rem;border-collapse:collapse;grid-column:1/-1;table-layout:auto}
#printed td,#printed th{padding:.1rem .3rem;overflow-wrap:anywhere}
#printed tr{break-inside:avoid}#prints p{grid-column:1/-1}
@media (max-width:60rem){#look{grid-template-columns:minmax(0,1fr)}#stage{order:0}#side{height:auto;min-height:0}}
@media print{#list-view>h2{display:none}#matrices td button{text-decoration:none;color:inherit}}
)css";

}  // namespace soms::report
