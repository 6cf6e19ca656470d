/// \file
/// The shaders, in GLSL 3.30. Private to the renderer.
///
/// Positions are relative to the eye ("device coordinates" of gl_view.h). Names shared by all:
/// `clip` takes them to the clip space, `lift` brings overlays nearer, `nearest` is the least w.
#pragma once

namespace soms::view::shader {

extern const char* const kSurfaceVertex;
extern const char* const kSurfaceFragment;

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

/// Factors by which surfaces are darkened, from their depths; with kBackgroundVertex.
extern const char* const kReliefFragment;

}  // namespace soms::view::shader
