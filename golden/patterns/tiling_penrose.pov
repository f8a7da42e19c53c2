// tiling: the three Penrose tilings 25 to 27, near and far.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb <0.1, 0.05, 0.3>] [0.35 rgb <0.9, 0.4, 0.2>] [0.65 rgb <0.4, 0.7, 0.3>] [0.95 rgb 1] [1 rgb 0] }
#for (K, 25, 27) Tile(pigment { tiling K color_map { Map } scale 0.15 rotate 80 * x translate 0.5 }) #end
#for (K, 25, 27) Tile(pigment { tiling K color_map { Map } scale 0.2 rotate <70, 10, 30> translate 1.2 }) #end
#for (K, 25, 27) Tile(pigment { tiling K color_map { Map } scale 0.3 rotate <-80, 40, 0> translate -2.7 }) #end
#for (K, 25, 27) Tile(pigment { tiling K color_map { Map } scale 0.1 rotate 90 * x translate 7 * x }) #end
