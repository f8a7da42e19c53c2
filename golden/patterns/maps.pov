// Maps: pigment_map, average, duplicated and unsorted entries, filter and transmit, nested maps, the old form.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

Tile(pigment { gradient x pigment_map { [0.2 rgb <0.9, 0.2, 0.1>] [0.6 checker scale 0.13 translate 0.013] [1 bozo scale 0.1] } })
Tile(pigment { onion pigment_map { [0 gradient y scale 0.2] [1 gradient x scale 0.2] } scale 0.5 translate 0.5 })
Tile(pigment { average pigment_map { [1 gradient x] [2 gradient y color_map { [0 rgb z] [1 rgb x] }] [0.5 checker scale 0.2 translate 0.013] } })
Tile(pigment { gradient x color_map { [0.1 rgb 0] [0.4 rgb x] [0.4 rgb y] [0.4 rgb z] [0.9 rgb 1] [0.9 rgb 0.3] } })
Tile(pigment { gradient x color_map { [0.8 rgb 0.8] [0.4 rgb <0.9, 0.4, 0>] [1 rgb <0, 0.5, 1>] } })
Tile(pigment { gradient x color_map { [0 0.4 color rgb x color rgb y] [0.4 1 color rgb y color rgb 1] } })
Tile(pigment { gradient y color_map { [0 rgbt <1, 0.2, 0, 0>] [1 rgbt <1, 0.2, 0, 1>] } })
Tile(pigment { gradient y color_map { [0 rgbf <1, 0.2, 0, 1>] [1 rgbf <0, 0.4, 1, 0.3>] } })
Tile(pigment { bozo scale 0.1 })
Tile(pigment { agate scale 0.4 })
Tile(pigment { gradient x turbulence 0.3 pigment_map { [0 gradient y scale 0.3] [1 onion scale 0.2] } })
Tile(pigment { spherical pigment_map { [0 rgb 0.1] [0.5 spherical pigment_map { [0 rgb x] [1 checker scale 0.1 translate 0.013] } scale 0.7] [1 rgb 1] } scale 0.7 translate 0.5 })
