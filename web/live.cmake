# The module of live reports: meshes from arrays, overlap and distance, nothing more; made as small as they get. Committed
# as apps/report/web/dist/live.txt, so this file and the sources are in its hash (web/pack_live.py): rebuild it by `make live`.

# What overlap and distance do without.
set(other_queries "/(parity|ray|reference|solid|winding)/|/print|/query/(closest|contains|contains_parts|near_triangles|ray|\
signed_closest|solid|winding|within)\\.cpp|/detail/(exact/|parts/)?(closed_surface|closed_unions|connected_parts|exact_ray|odd_edges|part_groups|point_goal|point_query|\
point_traversal|ray_plane)\\.cpp|/(bodies_of|closedness|defects|refit|statistics)\\.cpp")
soms_web_library(soms_tiny TINY base geometry tree query)
add_executable(soms_live bridge/answer.cpp bridge/crossings.cpp bridge/failure.cpp bridge/fast_alone.cpp bridge/meshes.cpp bridge/pairs.cpp
  bridge/simd128_alone.cpp)
set_target_properties(soms_live PROPERTIES OUTPUT_NAME live SUFFIX .wasm)
target_compile_options(soms_live PRIVATE -Oz)
target_link_libraries(soms_live PRIVATE soms_tiny)
target_link_options(soms_live PRIVATE -Oz --no-entry -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=4GB
  -sINITIAL_MEMORY=16MB -sTOTAL_STACK=1MB)
