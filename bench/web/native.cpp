// The same queries as bench.mjs, by the native library: native CITY.ply CAR.ply poses.bin [ROUNDS].
// SOMS_ISA selects the instruction set. Prints microseconds of processor time a pose, of the best
// round.
#include "soms/io/read_mesh.h"
#include "soms/query/instruction_set.h"
#include "soms/query/overlap.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace {

/// three.js keeps positions in float.
soms::Shape shape_of(const char* file) {
  soms::Mesh mesh = soms::read_mesh(std::string(file));
  for (soms::Vec3& vertex : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto rounded = static_cast<float>(vertex[axis]);
      vertex[axis] = rounded;
    }
  }
  return soms::Shape(std::move(mesh));
}

std::vector<soms::Pose> poses_of(const char* file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<soms::Pose> poses;
  soms::Pose pose;
  while (in.read(reinterpret_cast<char*>(pose.m.data()), sizeof pose.m)) {
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) {
    std::puts("native CITY.ply CAR.ply poses.bin [ROUNDS]");
    return 2;
  }
  const soms::Body city(shape_of(arguments[1]));
  const soms::Shape car = shape_of(arguments[2]);
  const std::vector<soms::Pose> poses = poses_of(arguments[3]);
  const int rounds = count > 4 ? std::atoi(arguments[4]) : 3;
  for (const soms::OverlapMode mode : {soms::OverlapMode::any, soms::OverlapMode::all}) {
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
      const std::clock_t before = std::clock();
      const soms::OverlapBatch found = overlap(car, poses, city, {.mode = mode});
      best = std::min(best, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
      if (found.size() != poses.size()) {
        return 1;
      }
    }
    std::printf("%s,\"native, %s\",%.3f\n", mode == soms::OverlapMode::any ? "any" : "all",
                std::string(soms::instruction_set()).c_str(),
                best * 1e6 / static_cast<double>(poses.size()));
  }
}
