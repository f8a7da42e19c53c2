// Vectors do not stand in functions.
#version 3.7;
isosurface { function { vlength(x) } }
