// One argument, not two.
#version 3.7;
isosurface { function { sin(x, y) } }
