// Each pigment on a box, each texture and material on a ball.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#include "textures.inc"
#declare Columns = 12;
#declare Rows = 7;
camera { orthographic location <Columns, -Rows, -50> direction z right 2 * Columns * x up 2 * Rows * y }
light_source { <-40, 50, -60> rgb 0.9 }
background { rgb <0.3, 0.4, 0.5> }
plane { -z, -8 pigment { gradient x triangle_wave color_map { [0 rgb 0.2] [1 rgb <0.9, 0.8, 0.7>] } scale 0.7 } finish { ambient 0.3 diffuse 0.5 } }
#declare N = 0;
#macro Next() rotate <20, 30, 10> translate <2 * mod(N, Columns) + 1, -2 * int(N / Columns) - 1, 0> #declare N = N + 1; #end
box { -0.9, 0.9 pigment { Jade } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Red_Marble } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { White_Marble } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Blood_Marble } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Blue_Agate } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Sapphire_Agate } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Brown_Agate } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Pink_Granite } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Blue_Sky } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Bright_Blue_Sky } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Blue_Sky2 } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Blue_Sky3 } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Blood_Sky } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Apocalypse } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Clouds } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Cherry_Wood } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Pine_Wood } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Dark_Wood } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Tan_Wood } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { White_Wood } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Tom_Wood } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { DMFWood1 } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { DMFWood2 } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { DMFWood3 } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { DMFWood4 } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { DMFWood5 } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Candy_Cane } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { X_Gradient } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { Y_Gradient } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { gradient x color_map { Lightning_CMap1 } } finish { ambient 0 diffuse 0 emission 1 } Next() }
box { -0.9, 0.9 pigment { gradient x color_map { Lightning_CMap2 } } finish { ambient 0 diffuse 0 emission 1 } Next() }
sphere { 0, 0.9 texture { Chrome_Metal } Next() }
sphere { 0, 0.9 texture { Brass_Metal } Next() }
sphere { 0, 0.9 texture { Bronze_Metal } Next() }
sphere { 0, 0.9 texture { Gold_Metal } Next() }
sphere { 0, 0.9 texture { Silver_Metal } Next() }
sphere { 0, 0.9 texture { Copper_Metal } Next() }
sphere { 0, 0.9 texture { Chrome_Texture } Next() }
sphere { 0, 0.9 texture { Brass_Texture } Next() }
sphere { 0, 0.9 texture { Bronze_Texture } Next() }
sphere { 0, 0.9 texture { Gold_Texture } Next() }
sphere { 0, 0.9 texture { Silver_Texture } Next() }
sphere { 0, 0.9 texture { Copper_Texture } Next() }
sphere { 0, 0.9 texture { Polished_Chrome } Next() }
sphere { 0, 0.9 texture { Polished_Brass } Next() }
sphere { 0, 0.9 texture { New_Brass } Next() }
sphere { 0, 0.9 texture { Spun_Brass } Next() }
sphere { 0, 0.9 texture { Brushed_Aluminum } Next() }
sphere { 0, 0.9 texture { Silver1 } Next() }
sphere { 0, 0.9 texture { Silver2 } Next() }
sphere { 0, 0.9 texture { Silver3 } Next() }
sphere { 0, 0.9 texture { Soft_Silver } Next() }
sphere { 0, 0.9 texture { New_Penny } Next() }
sphere { 0, 0.9 texture { Tinny_Brass } Next() }
sphere { 0, 0.9 texture { Aluminum } Next() }
sphere { 0, 0.9 texture { Bright_Bronze } Next() }
sphere { 0, 0.9 texture { Water } Next() }
sphere { 0, 0.9 texture { Glass } Next() }
sphere { 0, 0.9 texture { Glass2 } Next() }
sphere { 0, 0.9 texture { Glass3 } Next() }
sphere { 0, 0.9 texture { Green_Glass } Next() }
sphere { 0, 0.9 texture { NBglass } Next() }
sphere { 0, 0.9 texture { NBoldglass } Next() }
sphere { 0, 0.9 texture { NBwinebottle } Next() }
sphere { 0, 0.9 texture { NBbeerbottle } Next() }
sphere { 0, 0.9 texture { Ruby_Glass } Next() }
sphere { 0, 0.9 texture { Dark_Green_Glass } Next() }
sphere { 0, 0.9 texture { Yellow_Glass } Next() }
sphere { 0, 0.9 texture { Orange_Glass } Next() }
sphere { 0, 0.9 texture { Vicks_Bottle_Glass } Next() }
sphere { 0, 0.9 material { M_Water } Next() }
sphere { 0, 0.9 material { M_Glass } Next() }
sphere { 0, 0.9 material { M_Glass2 } Next() }
sphere { 0, 0.9 material { M_Glass3 } Next() }
sphere { 0, 0.9 material { M_Green_Glass } Next() }
sphere { 0, 0.9 material { M_NB_Glass } Next() }
sphere { 0, 0.9 material { M_NB_Old_Glass } Next() }
sphere { 0, 0.9 material { M_NB_Winebottle_Glass } Next() }
sphere { 0, 0.9 material { M_NB_Beerbottle_Glass } Next() }
sphere { 0, 0.9 material { M_Ruby_Glass } Next() }
sphere { 0, 0.9 material { M_Dark_Green_Glass } Next() }
sphere { 0, 0.9 material { M_Yellow_Glass } Next() }
sphere { 0, 0.9 material { M_Orange_Glass } Next() }
sphere { 0, 0.9 material { M_Vicks_Bottle_Glass } Next() }
