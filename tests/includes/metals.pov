// Each metal in each finish on a ball.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#include "metals.inc"
#declare Columns = 10;
#declare Rows = 10;
camera { orthographic location <Columns, -Rows, -50> direction z right 2 * Columns * x up 2 * Rows * y }
light_source { <-40, 50, -60> rgb 0.9 }
background { rgb <0.3, 0.4, 0.5> }
plane { -z, -8 pigment { gradient x triangle_wave color_map { [0 rgb 0.2] [1 rgb <0.9, 0.8, 0.7>] } scale 0.7 } finish { ambient 0.3 diffuse 0.5 } }
#declare N = 0;
#macro Next() rotate <20, 30, 10> translate <2 * mod(N, Columns) + 1, -2 * int(N / Columns) - 1, 0> #declare N = N + 1; #end
sphere { 0, 0.9 texture { T_Brass_1A } Next() }
sphere { 0, 0.9 texture { T_Brass_1B } Next() }
sphere { 0, 0.9 texture { T_Brass_1C } Next() }
sphere { 0, 0.9 texture { T_Brass_1D } Next() }
sphere { 0, 0.9 texture { T_Brass_1E } Next() }
sphere { 0, 0.9 texture { T_Brass_2A } Next() }
sphere { 0, 0.9 texture { T_Brass_2B } Next() }
sphere { 0, 0.9 texture { T_Brass_2C } Next() }
sphere { 0, 0.9 texture { T_Brass_2D } Next() }
sphere { 0, 0.9 texture { T_Brass_2E } Next() }
sphere { 0, 0.9 texture { T_Brass_3A } Next() }
sphere { 0, 0.9 texture { T_Brass_3B } Next() }
sphere { 0, 0.9 texture { T_Brass_3C } Next() }
sphere { 0, 0.9 texture { T_Brass_3D } Next() }
sphere { 0, 0.9 texture { T_Brass_3E } Next() }
sphere { 0, 0.9 texture { T_Brass_4A } Next() }
sphere { 0, 0.9 texture { T_Brass_4B } Next() }
sphere { 0, 0.9 texture { T_Brass_4C } Next() }
sphere { 0, 0.9 texture { T_Brass_4D } Next() }
sphere { 0, 0.9 texture { T_Brass_4E } Next() }
sphere { 0, 0.9 texture { T_Brass_5A } Next() }
sphere { 0, 0.9 texture { T_Brass_5B } Next() }
sphere { 0, 0.9 texture { T_Brass_5C } Next() }
sphere { 0, 0.9 texture { T_Brass_5D } Next() }
sphere { 0, 0.9 texture { T_Brass_5E } Next() }
sphere { 0, 0.9 texture { T_Copper_1A } Next() }
sphere { 0, 0.9 texture { T_Copper_1B } Next() }
sphere { 0, 0.9 texture { T_Copper_1C } Next() }
sphere { 0, 0.9 texture { T_Copper_1D } Next() }
sphere { 0, 0.9 texture { T_Copper_1E } Next() }
sphere { 0, 0.9 texture { T_Copper_2A } Next() }
sphere { 0, 0.9 texture { T_Copper_2B } Next() }
sphere { 0, 0.9 texture { T_Copper_2C } Next() }
sphere { 0, 0.9 texture { T_Copper_2D } Next() }
sphere { 0, 0.9 texture { T_Copper_2E } Next() }
sphere { 0, 0.9 texture { T_Copper_3A } Next() }
sphere { 0, 0.9 texture { T_Copper_3B } Next() }
sphere { 0, 0.9 texture { T_Copper_3C } Next() }
sphere { 0, 0.9 texture { T_Copper_3D } Next() }
sphere { 0, 0.9 texture { T_Copper_3E } Next() }
sphere { 0, 0.9 texture { T_Copper_4A } Next() }
sphere { 0, 0.9 texture { T_Copper_4B } Next() }
sphere { 0, 0.9 texture { T_Copper_4C } Next() }
sphere { 0, 0.9 texture { T_Copper_4D } Next() }
sphere { 0, 0.9 texture { T_Copper_4E } Next() }
sphere { 0, 0.9 texture { T_Copper_5A } Next() }
sphere { 0, 0.9 texture { T_Copper_5B } Next() }
sphere { 0, 0.9 texture { T_Copper_5C } Next() }
sphere { 0, 0.9 texture { T_Copper_5D } Next() }
sphere { 0, 0.9 texture { T_Copper_5E } Next() }
sphere { 0, 0.9 texture { T_Chrome_1A } Next() }
sphere { 0, 0.9 texture { T_Chrome_1B } Next() }
sphere { 0, 0.9 texture { T_Chrome_1C } Next() }
sphere { 0, 0.9 texture { T_Chrome_1D } Next() }
sphere { 0, 0.9 texture { T_Chrome_1E } Next() }
sphere { 0, 0.9 texture { T_Chrome_2A } Next() }
sphere { 0, 0.9 texture { T_Chrome_2B } Next() }
sphere { 0, 0.9 texture { T_Chrome_2C } Next() }
sphere { 0, 0.9 texture { T_Chrome_2D } Next() }
sphere { 0, 0.9 texture { T_Chrome_2E } Next() }
sphere { 0, 0.9 texture { T_Chrome_3A } Next() }
sphere { 0, 0.9 texture { T_Chrome_3B } Next() }
sphere { 0, 0.9 texture { T_Chrome_3C } Next() }
sphere { 0, 0.9 texture { T_Chrome_3D } Next() }
sphere { 0, 0.9 texture { T_Chrome_3E } Next() }
sphere { 0, 0.9 texture { T_Chrome_4A } Next() }
sphere { 0, 0.9 texture { T_Chrome_4B } Next() }
sphere { 0, 0.9 texture { T_Chrome_4C } Next() }
sphere { 0, 0.9 texture { T_Chrome_4D } Next() }
sphere { 0, 0.9 texture { T_Chrome_4E } Next() }
sphere { 0, 0.9 texture { T_Chrome_5A } Next() }
sphere { 0, 0.9 texture { T_Chrome_5B } Next() }
sphere { 0, 0.9 texture { T_Chrome_5C } Next() }
sphere { 0, 0.9 texture { T_Chrome_5D } Next() }
sphere { 0, 0.9 texture { T_Chrome_5E } Next() }
sphere { 0, 0.9 texture { T_Silver_1A } Next() }
sphere { 0, 0.9 texture { T_Silver_1B } Next() }
sphere { 0, 0.9 texture { T_Silver_1C } Next() }
sphere { 0, 0.9 texture { T_Silver_1D } Next() }
sphere { 0, 0.9 texture { T_Silver_1E } Next() }
sphere { 0, 0.9 texture { T_Silver_2A } Next() }
sphere { 0, 0.9 texture { T_Silver_2B } Next() }
sphere { 0, 0.9 texture { T_Silver_2C } Next() }
sphere { 0, 0.9 texture { T_Silver_2D } Next() }
sphere { 0, 0.9 texture { T_Silver_2E } Next() }
sphere { 0, 0.9 texture { T_Silver_3A } Next() }
sphere { 0, 0.9 texture { T_Silver_3B } Next() }
sphere { 0, 0.9 texture { T_Silver_3C } Next() }
sphere { 0, 0.9 texture { T_Silver_3D } Next() }
sphere { 0, 0.9 texture { T_Silver_3E } Next() }
sphere { 0, 0.9 texture { T_Silver_4A } Next() }
sphere { 0, 0.9 texture { T_Silver_4B } Next() }
sphere { 0, 0.9 texture { T_Silver_4C } Next() }
sphere { 0, 0.9 texture { T_Silver_4D } Next() }
sphere { 0, 0.9 texture { T_Silver_4E } Next() }
sphere { 0, 0.9 texture { T_Silver_5A } Next() }
sphere { 0, 0.9 texture { T_Silver_5B } Next() }
sphere { 0, 0.9 texture { T_Silver_5C } Next() }
sphere { 0, 0.9 texture { T_Silver_5D } Next() }
sphere { 0, 0.9 texture { T_Silver_5E } Next() }
