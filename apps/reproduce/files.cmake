set(SOMS_REPRODUCE_FILES
  draw_frames.cpp
  draw_frames.h
  main.cpp
  reproduce.cpp
  reproduce.h
)
