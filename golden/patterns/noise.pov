// Patterns made of noise: bozo with each generator, bumps, spotted, dents, granite, wrinkles, agate, and turbulence.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb <0.1, 0.05, 0.3>] [0.4 rgb <0.8, 0.3, 0.2>] [0.7 rgb <1, 0.8, 0.3>] [1 rgb 1] }
Tile(pigment { bozo color_map { Map } noise_generator 1 scale 0.15 })
Tile(pigment { bozo color_map { Map } noise_generator 2 scale 0.15 })
Tile(pigment { bozo color_map { Map } noise_generator 3 scale 0.15 })
Tile(pigment { spotted color_map { Map } scale 0.1 rotate 30 })
Tile(pigment { dents color_map { Map } scale 0.1 })
Tile(pigment { granite color_map { Map } scale 0.5 })
Tile(pigment { granite color_map { Map } noise_generator 1 scale 0.5 })
Tile(pigment { wrinkles color_map { Map } scale 0.3 })
Tile(pigment { wrinkles color_map { Map } noise_generator 1 scale 0.3 })
Tile(pigment { agate color_map { Map } scale 0.4 })
Tile(pigment { agate agate_turb 0.4 noise_generator 1 color_map { Map } scale 0.3 })
Tile(pigment { bumps turbulence 0.6 octaves 4 lambda 2.2 omega 0.6 color_map { Map } scale 0.2 })
