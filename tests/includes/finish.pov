// Each finish on a ball.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#include "finish.inc"
#declare Columns = 4;
#declare Rows = 2;
camera { orthographic location <Columns, -Rows, -50> direction z right 2 * Columns * x up 2 * Rows * y }
light_source { <-40, 50, -60> rgb 0.9 }
background { rgb <0.3, 0.4, 0.5> }
plane { -z, -8 pigment { gradient x triangle_wave color_map { [0 rgb 0.2] [1 rgb <0.9, 0.8, 0.7>] } scale 0.7 } finish { ambient 0.3 diffuse 0.5 } }
#declare N = 0;
#macro Next() rotate <20, 30, 10> translate <2 * mod(N, Columns) + 1, -2 * int(N / Columns) - 1, 0> #declare N = N + 1; #end
sphere { 0, 0.9 pigment { rgb <0.7, 0.5, 0.3> } finish { Dull } Next() }
sphere { 0, 0.9 pigment { rgb <0.7, 0.5, 0.3> } finish { Shiny } Next() }
sphere { 0, 0.9 pigment { rgb <0.7, 0.5, 0.3> } finish { Glossy } Next() }
sphere { 0, 0.9 pigment { rgb <0.7, 0.5, 0.3> } finish { Phong_Dull } Next() }
sphere { 0, 0.9 pigment { rgb <0.7, 0.5, 0.3> } finish { Phong_Shiny } Next() }
sphere { 0, 0.9 pigment { rgb <0.7, 0.5, 0.3> } finish { Phong_Glossy } Next() }
sphere { 0, 0.9 pigment { rgb <0.7, 0.5, 0.3> } finish { Luminous } Next() }
sphere { 0, 0.9 pigment { rgb <0.7, 0.5, 0.3> } finish { Mirror } Next() }
