# Which moment and place of a scene a picture shows.
set(SOMS_VIEW_HEADERS
  aim.h
  bulk.h
  dense_place.h
  rich_frame.h
)
set(SOMS_VIEW_SOURCES
  aim.cpp
  bulk.cpp
  dense_place.cpp
  rich_frame.cpp
)
