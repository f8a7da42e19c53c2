// whitted: expanded scene, format 1
#version 3.8;
sphere { <0, 0, 0>, 1 }
