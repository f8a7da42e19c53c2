// The order of transforms, warps and turbulence within a pigment, and transforms outside it.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end
#macro Tex(T) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> texture { T } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb <0.1, 0.05, 0.3>] [0.4 rgb <0.8, 0.3, 0.2>] [0.7 rgb <1, 0.8, 0.3>] [1 rgb 1] }
Tile(pigment { gradient x turbulence 0.3 color_map { Map } scale 0.4 rotate 30 * z })
Tile(pigment { gradient x color_map { Map } scale 0.4 turbulence 0.3 rotate 30 * z })
Tile(pigment { gradient x color_map { Map } warp { turbulence 0.3 } scale 0.4 rotate 30 * z })
Tile(pigment { gradient x color_map { Map } scale 0.4 rotate 30 * z warp { turbulence 0.3 } })
Tile(pigment { onion color_map { Map } translate 0.3 scale 0.4 })
Tile(pigment { onion color_map { Map } scale 0.4 translate 0.3 })
Tile(pigment { onion color_map { Map } scale <0.1, 0.3, 1> rotate 40 * z translate 0.5 })
Tile(pigment { onion color_map { Map } rotate 40 * z scale <0.1, 0.3, 1> translate 0.5 })
Tex(texture { pigment { onion color_map { Map } scale 0.3 } finish { emission 1 diffuse 0 } scale <1, 0.5, 1> translate 0.4 })
Tile(pigment { onion color_map { Map } scale 0.3 matrix <1, 0.5, 0, -0.3, 1, 0, 0, 0, 1, 0.4, 0.2, 0> })
Tile(pigment { onion color_map { Map } scale 0.3 transform { rotate 20 * z scale <2, 1, 1> translate 0.4 inverse } })
Tile(pigment { wood color_map { Map } scale 0.1 rotate 90 * y scale <1, 2, 1> rotate 30 * z })
