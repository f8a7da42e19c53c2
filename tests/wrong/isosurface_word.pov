// A word of an isosurface that does not exist.
#version 3.7;
isosurface { function { x } max_gradiant 3 }
