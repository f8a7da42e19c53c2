// Each colour, printed; each finish, interior and texture on a ball.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#include "glass.inc"
#declare Columns = 8;
#declare Rows = 5;
camera { orthographic location <Columns, -Rows, -50> direction z right 2 * Columns * x up 2 * Rows * y }
light_source { <-40, 50, -60> rgb 0.9 }
background { rgb <0.3, 0.4, 0.5> }
plane { -z, -8 pigment { gradient x triangle_wave color_map { [0 rgb 0.2] [1 rgb <0.9, 0.8, 0.7>] } scale 0.7 } finish { ambient 0.3 diffuse 0.5 } }
#declare N = 0;
#macro Next() rotate <20, 30, 10> translate <2 * mod(N, Columns) + 1, -2 * int(N / Columns) - 1, 0> #declare N = N + 1; #end
#macro Show(C) #debug concat("@", vstr(5, C, ", ", 0, 9), "\n") #end
Show(1 * Col_Amber_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amber_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amber_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amber_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amber_05 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amber_06 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amber_07 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amber_08 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amber_09 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amethyst_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amethyst_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amethyst_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amethyst_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amethyst_05 + <0, 0, 0, 0, 0>)
Show(1 * Col_Amethyst_06 + <0, 0, 0, 0, 0>)
Show(1 * Col_Apatite_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Apatite_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Apatite_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Apatite_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Apatite_05 + <0, 0, 0, 0, 0>)
Show(1 * Col_Aquamarine_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Aquamarine_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Aquamarine_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Aquamarine_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Aquamarine_05 + <0, 0, 0, 0, 0>)
Show(1 * Col_Aquamarine_06 + <0, 0, 0, 0, 0>)
Show(1 * Col_Azurite_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Azurite_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Azurite_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Azurite_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Beerbottle + <0, 0, 0, 0, 0>)
Show(1 * Col_Blue_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Blue_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Blue_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Blue_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Citrine_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Dark_Green + <0, 0, 0, 0, 0>)
Show(1 * Col_Emerald_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Emerald_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Emerald_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Emerald_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Emerald_05 + <0, 0, 0, 0, 0>)
Show(1 * Col_Emerald_06 + <0, 0, 0, 0, 0>)
Show(1 * Col_Emerald_07 + <0, 0, 0, 0, 0>)
Show(1 * Col_Fluorite_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Fluorite_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Fluorite_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Fluorite_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Fluorite_05 + <0, 0, 0, 0, 0>)
Show(1 * Col_Fluorite_06 + <0, 0, 0, 0, 0>)
Show(1 * Col_Fluorite_07 + <0, 0, 0, 0, 0>)
Show(1 * Col_Fluorite_08 + <0, 0, 0, 0, 0>)
Show(1 * Col_Fluorite_09 + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Beerbottle + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Bluish + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Clear + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Dark_Green + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_General + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Green + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Old + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Orange + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Ruby + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Vicksbottle + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Winebottle + <0, 0, 0, 0, 0>)
Show(1 * Col_Glass_Yellow + <0, 0, 0, 0, 0>)
Show(1 * Col_Green + <0, 0, 0, 0, 0>)
Show(1 * Col_Green_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Green_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Green_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Green_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Gypsum_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Gypsum_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Gypsum_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Gypsum_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Gypsum_05 + <0, 0, 0, 0, 0>)
Show(1 * Col_Gypsum_06 + <0, 0, 0, 0, 0>)
Show(1 * Col_Orange + <0, 0, 0, 0, 0>)
Show(1 * Col_Red_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Red_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Red_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Red_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Ruby + <0, 0, 0, 0, 0>)
Show(1 * Col_Ruby_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Ruby_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Ruby_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Ruby_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Ruby_05 + <0, 0, 0, 0, 0>)
Show(1 * Col_Sapphire_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Sapphire_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Sapphire_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Topaz_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Topaz_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Topaz_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Tourmaline_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Tourmaline_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Tourmaline_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Tourmaline_04 + <0, 0, 0, 0, 0>)
Show(1 * Col_Tourmaline_05 + <0, 0, 0, 0, 0>)
Show(1 * Col_Tourmaline_06 + <0, 0, 0, 0, 0>)
Show(1 * Col_Vicksbottle + <0, 0, 0, 0, 0>)
Show(1 * Col_Winebottle + <0, 0, 0, 0, 0>)
Show(1 * Col_Yellow + <0, 0, 0, 0, 0>)
Show(1 * Col_Yellow_01 + <0, 0, 0, 0, 0>)
Show(1 * Col_Yellow_02 + <0, 0, 0, 0, 0>)
Show(1 * Col_Yellow_03 + <0, 0, 0, 0, 0>)
Show(1 * Col_Yellow_04 + <0, 0, 0, 0, 0>)
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass2 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass3 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass4 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass5 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass6 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass7 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass8 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass9 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass10 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass1 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass2 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass4 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Fade_Sqr1 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Fade_Exp1 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Fade_Exp2 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Fade_Exp3 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Dispersion1 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Dispersion2 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Caustics1 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Caustics2 } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Exp(2) } Next() }
sphere { 0, 0.9 texture { pigment { Col_Glass_Clear } finish { F_Glass1 } } interior { I_Glass_Sqr(3) } Next() }
sphere { 0, 0.9 texture { T_Glass1 } Next() }
sphere { 0, 0.9 texture { T_Glass2 } Next() }
sphere { 0, 0.9 texture { T_Glass3 } Next() }
sphere { 0, 0.9 texture { T_Glass4 } Next() }
sphere { 0, 0.9 texture { T_Old_Glass } Next() }
sphere { 0, 0.9 texture { T_Winebottle_Glass } Next() }
sphere { 0, 0.9 texture { T_Beerbottle_Glass } Next() }
sphere { 0, 0.9 texture { T_Ruby_Glass } Next() }
sphere { 0, 0.9 texture { T_Green_Glass } Next() }
sphere { 0, 0.9 texture { T_Dark_Green_Glass } Next() }
sphere { 0, 0.9 texture { T_Yellow_Glass } Next() }
sphere { 0, 0.9 texture { T_Orange_Glass } Next() }
sphere { 0, 0.9 texture { T_Vicksbottle_Glass } Next() }
