// Patterns given by a formula: boxed, cylindrical, planar, spherical, gradient, onion, leopard, radial, wood, marble, spirals.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb <0.1, 0.05, 0.3>] [0.4 rgb <0.8, 0.3, 0.2>] [0.7 rgb <1, 0.8, 0.3>] [1 rgb 1] }
Tile(pigment { boxed color_map { Map } scale 0.6 rotate 10 * y translate <0.5, 0.4, 0.1> })
Tile(pigment { cylindrical color_map { Map } scale 0.5 rotate 60 * x translate <0.5, 0.5, 0> })
Tile(pigment { planar color_map { Map } scale 0.5 rotate 30 * z translate 0.5 })
Tile(pigment { spherical color_map { Map } scale 0.6 translate 0.5 * x + 0.4 * y })
Tile(pigment { gradient <1, 2, 0.5> color_map { Map } scale 0.3 })
Tile(pigment { onion color_map { Map } scale 0.2 translate 0.4 })
Tile(pigment { leopard color_map { Map } scale 0.05 })
Tile(pigment { radial color_map { Map } frequency 3 rotate 70 * x translate 0.45 })
Tile(pigment { wood color_map { Map } scale 0.15 rotate <20, 30, 0> translate 0.4 })
Tile(pigment { marble color_map { Map } scale 0.3 rotate 40 * z })
Tile(pigment { spiral1 3 color_map { Map } scale 0.3 translate 0.5 })
Tile(pigment { spiral2 4 color_map { Map } scale 0.3 translate 0.5 })
