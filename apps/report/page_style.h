/// \file
/// How the view of a scene looks; the rest of the page looks as apps/draw/page_style.h says.
#pragma once

#include <string_view>

namespace soms::report {

inline constexpr std::string_view kViewStyle = R"css(
body{max-width:100rem;padding-top:.6rem}
[hidden]{display:none!important}
#first{display:flex;flex-direction:column;gap:.4rem;height:max(33rem,min(62rem,100vh - 1.2rem))}
#first:has(#look[hidden]){height:auto}
#first>*{flex:none;margin:0}
#first h1{font-size:1.5rem}
#first .lead{max-width:none}
#warnings{max-height:7.6rem;overflow-y:auto}
#warnings .warn{margin:0 0 .3rem;padding:.25rem .7rem;font-size:.88rem}
#first #view{flex:1 1 0;min-height:0;display:flex;flex-direction:column}
dl.facts{display:grid;grid-template-columns:max-content 1fr;gap:.2rem 1rem;margin:.6rem 0;
max-width:60rem}
dl.facts dt{color:var(--faint)}
dl.facts dd{margin:0;overflow-wrap:anywhere}
details.fold{border-top:1px solid var(--line);margin:0;padding:.5rem 0}
details.fold>summary{font-size:1.15rem;font-weight:600}
#drawn{margin:.3rem 0 .6rem}
h1,.lead,#picked,.note,.warn{overflow-wrap:anywhere}
#look{flex:1 1 0;min-height:0;display:grid;grid-template:minmax(0,1fr)/minmax(0,1fr) 24rem;gap:.5rem 1rem}
#sight,#beside{display:flex;flex-direction:column;gap:.35rem;min-width:0;min-height:0}
#answer figure{flex:none;margin:0}
#answer figure svg{min-width:0}#answer figcaption{font-size:.85rem;padding-top:.2rem}#answer .facts{font-size:.92rem;margin:.2rem 0}
#answer .picture{max-width:none}
#stage{position:relative;flex:1 1 0;min-height:12rem;border:1px solid var(--line);
border-radius:.4rem;overflow:hidden}
#canvas{display:block;width:100%;height:100%}
#canvas:focus-visible,#list:focus-visible{outline:3px solid var(--link);outline-offset:-3px}
.gaps,#spots{position:absolute;inset:0;width:100%;height:100%;overflow:hidden;pointer-events:none}
.gaps line{stroke:var(--ink);stroke-width:2.5}.gaps .halo{stroke:var(--paper);stroke-width:6;stroke-opacity:.8}
.gaps circle{fill:var(--ink);stroke:var(--paper)}
.gaps.many .far .halo,.gaps.many .far circle{display:none}.gaps.many .far .ink{stroke-width:1.5}
.gaps .was .ink{stroke-dasharray:6 4}.gaps .far{opacity:.45}.gaps .chosen .ink{stroke-width:3.5}
.gaps text{font:600 13px system-ui,sans-serif;fill:var(--ink);stroke:var(--paper);stroke-width:4;
stroke-linejoin:round;paint-order:stroke;text-anchor:middle}
#spots circle{fill:var(--contact);stroke:var(--paper);stroke-width:2}#spots .was circle{fill:var(--contact-past)}
#spots text{font:600 11px system-ui,sans-serif;fill:var(--paper);text-anchor:middle;dominant-baseline:central}
#trouble{position:absolute;inset:0;margin:0;padding:2rem;background:var(--warn);max-width:none}
#tools{position:absolute;top:.5rem;left:.5rem;display:flex;flex-wrap:wrap;gap:.4rem}
#missing{position:absolute;left:.5rem;bottom:.5rem;max-width:70%;margin:0;padding:.1rem .5rem;
font-size:.85rem;background:var(--paper);border-radius:.3rem}
#keys{position:absolute;right:.5rem;bottom:.5rem;max-width:min(24rem,90%);margin:0}
#keys summary{text-align:right;text-shadow:0 0 3px var(--paper)}
#keys div{background:var(--paper);border:1px solid var(--line);border-radius:.4rem;
padding:.5rem .75rem;font-size:.9rem}
#look button,#look input,#look select{font:inherit;color:inherit;background:var(--paper);
border:1px solid var(--faint);border-radius:.35rem;padding:.25rem .6rem;min-height:2.25rem}
#look button{cursor:pointer}
#look button:hover{background:var(--soft)}
#side{display:flex;flex:1 1 0;flex-direction:column;gap:.4rem;min-width:0;min-height:0}
#side .row{display:flex;flex-wrap:wrap;gap:.4rem;align-items:center}
#find{flex:1 1 100%;min-width:0}
#order{flex:1 1 8rem;min-width:0}
#side label{white-space:nowrap;font-size:.9rem}
#look input[type=checkbox]{min-height:0;vertical-align:middle}
#count{margin:0;font-size:.9rem;color:var(--faint)}
#list{position:relative;flex:1;min-height:0;overflow-y:auto;border:1px solid var(--line);
border-radius:.4rem}
#rows{position:relative}
.line{position:absolute;left:0;right:0;height:92px;box-sizing:border-box;padding:.2rem .6rem;
cursor:pointer;border-bottom:1px solid var(--line);border-left:4px solid transparent;overflow:hidden;
font-size:.88rem;line-height:1.35}
.line:hover{background:var(--soft)}
.line.lasts{border-left-color:var(--contact)}
.line.perhaps{border-left:4px dotted var(--contact)}
.line[aria-selected=true]{background:var(--soft);box-shadow:inset 0 0 0 2px var(--link)}
.line b{display:-webkit-box;-webkit-line-clamp:2;-webkit-box-orient:vertical;overflow:hidden;
overflow-wrap:anywhere}
.line .what{display:-webkit-box;-webkit-line-clamp:2;-webkit-box-orient:vertical;overflow:hidden}
.line b{font-weight:600}
.line .what{color:var(--faint)}
.line.pair{padding-left:1.7rem}
.line .fold{position:absolute;left:0;top:0;bottom:0;width:1.7rem;text-align:center;font-size:1.1rem;
line-height:2}
.line.contact,.line.left{padding-left:2.9rem}
.line.contact b{font-weight:400}
.line.left{cursor:default}
.line.left .what{-webkit-line-clamp:4;font-style:italic}
.line .when{position:relative;display:block;height:5px;margin-top:3px;background:var(--line);
border-radius:3px;overflow:hidden}
.line .when i{position:absolute;top:0;bottom:0;min-width:3px;background:var(--contact)}
#time{display:flex;flex-wrap:wrap;align-items:center;gap:.5rem .75rem}
#step{flex:1 1 12rem;min-width:0;padding:0!important;accent-color:var(--contact)}
#moment{font-variant-numeric:tabular-nums;min-width:11rem}
#way{position:relative;flex:1 1 14rem;min-width:0;display:flex}
#look #part{position:relative;z-index:1;width:100%;min-width:0;margin:0;padding:0;border:0;background:none;appearance:none}
#part::-webkit-slider-thumb{appearance:none;width:16px;height:16px;border-radius:50%;background:var(--ink);border:2px solid var(--paper)}
#part::-moz-range-thumb{width:12px;height:12px;border-radius:50%;background:var(--ink);border:2px solid var(--paper)}
#track{position:absolute;top:calc(50% - .3rem);left:8px;right:8px;display:flex;height:.6rem;border-radius:.3rem;overflow:hidden;background:var(--line)}
#before{background:var(--body-a)}#open{background:var(--faint)}#after{background:var(--contact-past)}
#meets{position:absolute;top:0;bottom:0;width:4px;margin-left:-2px;background:var(--contact)}
.line.motion{border-left-color:var(--body-a)}.line.motion.lasts{border-left-color:var(--contact)}
.line.motion .when{background:var(--body-a)}.line.motion .when i{min-width:3px;background:var(--contact)}
#picked{margin:0;min-height:1.5rem;max-width:none;font-weight:600}
#look .note{margin:0;max-width:none}
#look button[aria-pressed=true]{background:var(--ink);color:var(--paper)}
#live p{margin:0}#live-answer{font-weight:600;font-variant-numeric:tabular-nums}
#live-pose{user-select:all;overflow-wrap:anywhere}.moving #canvas{cursor:grab}.held #canvas{cursor:grabbing}
.moving #gaps,.moving #spots,.moving #missing{display:none}
.moving #side{opacity:.5}.moving #picked:empty{display:none}.waiting #live-answer{opacity:.6}
.key{display:inline-block;width:.8em;height:.8em;border-radius:.2em;vertical-align:-.05em;
margin:0 .3em 0 .6em}
.key.moves{background:var(--body-a)}.key.still{background:var(--body-b)}.key.touch{background:var(--contact)}.key.was{background:var(--contact-past)}
.key.rest{background:var(--rest);border:1px solid var(--faint)}#within{background:var(--paper);border:1px solid var(--faint);border-radius:.35rem;padding:0 .2rem}
#within button{border:0;background:none}#which{font-variant-numeric:tabular-nums}
.key.gap{height:.2em;vertical-align:.25em;border-radius:0;background:var(--ink)}
#plots{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,34rem),1fr));gap:0 1.5rem}
#plots figure{min-width:0}
.no-list #beside,.no-list .touching{display:none}
.no-list #look{grid-template-columns:minmax(0,1fr)}
#answer{min-height:0;overflow-y:auto}
@media (min-width:60.01rem){#first #view.has-plot{display:grid;gap:.5rem 1rem;
grid-template:minmax(0,auto) minmax(13rem,1fr)/minmax(0,1.2fr) minmax(0,1fr)}
#first #view.has-plot.no-list{grid-template-rows:minmax(0,1fr) 0}
.has-plot #look{display:contents}.has-plot #sight{grid-area:1/1/3/2}.has-plot #beside{grid-area:2/2/3/3}#answer{grid-area:1/2/2/3}}
@media (max-width:60rem){#first{height:auto}#warnings{max-height:none;order:1}#look,#first #view{display:block}#first #view{flex:none}
#sight{margin-bottom:.6rem}#stage{flex:none;height:50vh;min-height:15rem;max-height:30rem}#side{height:26rem;flex:none}
dl.facts{grid-template-columns:minmax(0,1fr);gap:0}dl.facts dd{margin-bottom:.4rem}}
@media (max-width:40rem){.stacked thead{display:none}.stacked,.stacked tbody,.stacked tr{display:block}
.stacked tr{border-bottom:1px solid var(--line);padding:.3rem 0}
.stacked td{display:grid;grid-template-columns:8rem minmax(0,1fr);gap:.6rem;border:0;padding:.1rem .25rem;overflow-wrap:anywhere}
.stacked td:empty{display:none}.stacked td::before{content:attr(data-name);color:var(--faint)}}
#prints{display:none}
.picture{overflow-x:auto;background:linear-gradient(90deg,var(--paper) 40%,transparent) 0 0/3rem 100% local no-repeat,
linear-gradient(270deg,var(--paper) 40%,transparent) 100% 0/3rem 100% local no-repeat,
linear-gradient(90deg,var(--faint),transparent) 0 0/.7rem 100% scroll no-repeat,
linear-gradient(270deg,var(--faint),transparent) 100% 0/.7rem 100% scroll no-repeat}
@page{size:A4;margin:14mm}
@media print{#look{display:none!important}#first #view.has-plot{display:block}#first{display:block;height:auto}#warnings{max-height:none}
details.fold>summary{list-style:none;color:var(--ink)}.stacked{font-size:.7rem}.stacked td,.stacked th{padding:.15rem .4rem;overflow-wrap:break-word}
body{padding:0}#prints{display:grid;grid-template-columns:1fr 1fr;gap:.8rem 1rem}
#prints h2{grid-column:1/-1;margin:.5rem 0 0}
#prints figure{margin:0;break-inside:avoid}#prints canvas{width:100%;display:block;border:1px solid var(--line)}
#prints figcaption{font-size:.8rem;overflow-wrap:anywhere}.picture{background:none;overflow:hidden}
figure,.warn{break-inside:avoid}}
)css";

}  // namespace soms::report
