// Each gold in each finish on a ball; the colours behind them, printed.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#include "golds.inc"
#declare Columns = 5;
#declare Rows = 5;
camera { orthographic location <Columns, -Rows, -50> direction z right 2 * Columns * x up 2 * Rows * y }
light_source { <-40, 50, -60> rgb 0.9 }
background { rgb <0.3, 0.4, 0.5> }
plane { -z, -8 pigment { gradient x triangle_wave color_map { [0 rgb 0.2] [1 rgb <0.9, 0.8, 0.7>] } scale 0.7 } finish { ambient 0.3 diffuse 0.5 } }
#declare N = 0;
#macro Next() rotate <20, 30, 10> translate <2 * mod(N, Columns) + 1, -2 * int(N / Columns) - 1, 0> #declare N = N + 1; #end
#macro Show(C) #debug concat("@", vstr(3, C, ", ", 0, 5), "\n") #end
Show(<0, 0, 0> + GoldBase)
Show(<0, 0, 0> + CVect1)
Show(<0, 0, 0> + CVect2)
Show(<0, 0, 0> + CVect3)
Show(<0, 0, 0> + CVect4)
Show(<0, 0, 0> + CVect5)
Show(<0, 0, 0> + A_GoldA)
Show(<0, 0, 0> + A_GoldB)
Show(<0, 0, 0> + A_GoldC)
Show(<0, 0, 0> + A_GoldD)
Show(<0, 0, 0> + A_GoldE)
Show(<0, 0, 0> + R_GoldA)
Show(<0, 0, 0> + R_GoldB)
Show(<0, 0, 0> + R_GoldC)
Show(<0, 0, 0> + R_GoldD)
Show(<0, 0, 0> + R_GoldE)
Show(<0, 0, 0> + D_GoldA)
Show(<0, 0, 0> + D_GoldB)
Show(<0, 0, 0> + D_GoldC)
Show(<0, 0, 0> + D_GoldD)
Show(<0, 0, 0> + D_GoldE)
sphere { 0, 0.9 texture { T_Gold_1A } Next() }
sphere { 0, 0.9 texture { T_Gold_1B } Next() }
sphere { 0, 0.9 texture { T_Gold_1C } Next() }
sphere { 0, 0.9 texture { T_Gold_1D } Next() }
sphere { 0, 0.9 texture { T_Gold_1E } Next() }
sphere { 0, 0.9 texture { T_Gold_2A } Next() }
sphere { 0, 0.9 texture { T_Gold_2B } Next() }
sphere { 0, 0.9 texture { T_Gold_2C } Next() }
sphere { 0, 0.9 texture { T_Gold_2D } Next() }
sphere { 0, 0.9 texture { T_Gold_2E } Next() }
sphere { 0, 0.9 texture { T_Gold_3A } Next() }
sphere { 0, 0.9 texture { T_Gold_3B } Next() }
sphere { 0, 0.9 texture { T_Gold_3C } Next() }
sphere { 0, 0.9 texture { T_Gold_3D } Next() }
sphere { 0, 0.9 texture { T_Gold_3E } Next() }
sphere { 0, 0.9 texture { T_Gold_4A } Next() }
sphere { 0, 0.9 texture { T_Gold_4B } Next() }
sphere { 0, 0.9 texture { T_Gold_4C } Next() }
sphere { 0, 0.9 texture { T_Gold_4D } Next() }
sphere { 0, 0.9 texture { T_Gold_4E } Next() }
sphere { 0, 0.9 texture { T_Gold_5A } Next() }
sphere { 0, 0.9 texture { T_Gold_5B } Next() }
sphere { 0, 0.9 texture { T_Gold_5C } Next() }
sphere { 0, 0.9 texture { T_Gold_5D } Next() }
sphere { 0, 0.9 texture { T_Gold_5E } Next() }
