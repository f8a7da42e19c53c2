// What black holes take.
#version 3.7;
sphere { 0, 1 pigment { bozo warp { black_hole 0, 1 radius 2 } } }
