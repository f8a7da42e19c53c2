// pavement: squares, triangles and hexagons with interior, exterior and form.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb <0.9, 0.6, 0.3>] [0.6 rgb <0.8, 0.3, 0.2>] [0.8 rgb 0.2] [1 rgb 1] }
#macro Paved(S, T, P, A, B, C)
  Tile(pigment { pavement number_of_sides S number_of_tiles T pattern P interior A exterior B form C color_map { Map } scale 0.21 rotate 80 * x translate 0.013 })
#end
Paved(3, 1, 1, 0, 0, 0)
Paved(3, 3, 1, 1, 1, 1)
Paved(3, 5, 4, 2, 2, 2)
Paved(3, 6, 12, 0, 1, 1)
Paved(4, 2, 1, 0, 0, 0)
Paved(4, 4, 3, 1, 1, 1)
Paved(4, 5, 11, 2, 2, 2)
Paved(4, 6, 35, 0, 1, 3)
Paved(6, 1, 1, 0, 0, 0)
Paved(6, 3, 2, 1, 0, 1)
Paved(6, 4, 7, 2, 0, 2)
Paved(6, 5, 22, 1, 0, 1)
