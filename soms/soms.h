/// \file
/// The facade: all that most programs need.
#pragma once

#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/base/pose.h"
#include "soms/generate/city.h"
#include "soms/generate/routes.h"
#include "soms/generate/shapes.h"
#include "soms/generate/urban.h"
#include "soms/geometry/defects.h"
#include "soms/geometry/mesh.h"
#include "soms/geometry/orientation.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/io/poses.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"
#include "soms/query/overlap.h"
#include "soms/scene/scene.h"
#include "soms/tree/build.h"
#include "soms/tree/shape.h"
#include "soms/tree/statistics.h"
