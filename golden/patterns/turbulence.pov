// Classic turbulence: its own meaning for marble, wood and spirals; octaves, lambda and omega.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb <0.1, 0.05, 0.3>] [0.4 rgb <0.8, 0.3, 0.2>] [0.7 rgb <1, 0.8, 0.3>] [1 rgb 1] }
Tile(pigment { marble turbulence 0.5 color_map { Map } scale 0.3 })
Tile(pigment { marble turbulence 1 noise_generator 1 color_map { Map } scale 0.3 })
Tile(pigment { marble turbulence 1 noise_generator 3 octaves 3 color_map { Map } scale 0.3 })
Tile(pigment { wood turbulence 0.1 color_map { Map } scale 0.2 translate 0.4 })
Tile(pigment { wood turbulence <0.3, 0.05, 0> omega 0.7 color_map { Map } scale 0.2 translate 0.4 })
Tile(pigment { spiral1 2 turbulence 0.3 color_map { Map } scale 0.3 translate 0.5 })
Tile(pigment { spiral2 2 turbulence 0.2 color_map { Map } scale 0.3 translate 0.5 })
Tile(pigment { gradient x turbulence 0.4 lambda 3 color_map { Map } scale 0.4 })
Tile(pigment { onion turbulence <0.5, 0, 0> octaves 1 color_map { Map } scale 0.3 })
Tile(pigment { radial turbulence 0.3 color_map { Map } rotate 90 * x translate 0.5 })
Tile(pigment { agate turbulence 0.5 color_map { Map } scale 0.3 })
Tile(pigment { leopard turbulence 2 omega 0.3 color_map { Map } scale 0.07 })
