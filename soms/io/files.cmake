set(SOMS_HEADERS poses.h read_mesh.h write_mesh.h)
    set(SOMS_SOURCES detail / file.cpp detail / format.cpp detail / mesh_builder.cpp detail /
        ply.cpp detail / ply_binary.cpp detail / ply_header.cpp detail / ply_text.cpp detail /
        source.cpp detail / text.cpp read_mesh.cpp)
