// cells and crackle: form, metric, offset, solid, turbulence.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb <0.1, 0.05, 0.3>] [0.3 rgb <0.8, 0.3, 0.2>] [0.6 rgb <1, 0.8, 0.3>] [1 rgb 1] }
Tile(pigment { cells color_map { Map } scale 0.13 translate 0.013 })
Tile(pigment { cells color_map { Map } scale 0.2 rotate <20, 40, 30> })
Tile(pigment { crackle color_map { Map } scale 0.25 })
Tile(pigment { crackle form <1, 0, 0> color_map { Map } scale 0.25 })
Tile(pigment { crackle form <0, 0.5, 0.2> color_map { Map } scale 0.25 })
Tile(pigment { crackle metric 1 color_map { Map } scale 0.25 })
Tile(pigment { crackle metric 4 form <0.8, 0, 0> color_map { Map } scale 0.25 })
Tile(pigment { crackle offset 0.4 form <1, 0, 0> color_map { Map } scale 0.25 })
Tile(pigment { crackle solid color_map { Map } scale 0.2 })
Tile(pigment { crackle solid noise_generator 1 color_map { Map } scale 0.2 })
Tile(pigment { crackle turbulence 0.4 color_map { Map } scale 0.25 })
Tile(pigment { crackle form <-2, 2.5, -0.5> color_map { Map } scale 0.25 rotate 30 })
