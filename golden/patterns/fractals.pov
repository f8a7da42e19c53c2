// mandel, julia and magnet with exponents, interior and exterior types.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb 0] [0.1 rgb <0.2, 0.1, 0.6>] [0.3 rgb <0.9, 0.4, 0.1>] [0.6 rgb <1, 0.9, 0.5>] [1 rgb 1] }
Tile(pigment { mandel 30 color_map { Map } scale 0.35 translate <0.65, 0.5, 0> })
Tile(pigment { mandel 20 scale 0.35 translate <0.65, 0.5, 0> })
Tile(pigment { mandel 20 exponent 3 color_map { Map } interior 2, 1 scale 0.35 translate 0.5 })
Tile(pigment { mandel 20 exponent 5 color_map { Map } exterior 6, 0.1 scale 0.35 translate 0.5 })
Tile(pigment { julia <0.353, 0.288>, 25 color_map { Map } scale 0.35 translate 0.5 })
Tile(pigment { julia <-0.7, 0.3>, 20 color_map { Map } interior 5, 3 exterior 8, 4 scale 0.35 translate 0.5 })
Tile(pigment { julia <0.4, 0.1>, 20 exponent 4 color_map { Map } exterior 2, 0.3 scale 0.35 translate 0.5 })
Tile(pigment { magnet 1 mandel 25 color_map { Map } scale 0.2 translate <0.2, 0.5, 0> })
Tile(pigment { magnet 2 mandel 25 color_map { Map } interior 1, 0.5 scale 0.25 translate <0.2, 0.5, 0> })
Tile(pigment { magnet 1 julia <1.3, 0.4>, 20 color_map { Map } scale 0.2 translate 0.5 })
Tile(pigment { magnet 2 julia <1.5, 0.6>, 20 color_map { Map } exterior 7, 5 scale 0.2 translate 0.5 })
Tile(pigment { mandel 15 color_map { Map } exterior 3, 0.4 interior 6, 1 scale 0.35 translate <0.65, 0.5, 0> })
