# The verbs of soms-view: their options, and what they do.
set(SOMS_VIEW_HEADERS
  verbs.h
  view.h
)
set(SOMS_VIEW_SOURCES
  verbs.cpp
  view.cpp
)
