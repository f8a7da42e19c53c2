// whitted: expanded scene, format 1
#version 3.70;
camera { perspective location <0, 0, -3> direction <0, 0, 1> up <0, 1, 0> right <1.33, 0, 0> }
sphere { <0, 0, 0>, 1 + 1 }
