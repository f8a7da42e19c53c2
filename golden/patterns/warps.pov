// Warps: repeat with flip and offset, black_hole, turbulence, cylindrical, spherical, toroidal, planar, cubic.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb <0.1, 0.05, 0.3>] [0.4 rgb <0.8, 0.3, 0.2>] [0.7 rgb <1, 0.8, 0.3>] [1 rgb 1] }
#declare Grid = pigment { checker rgb <0.9, 0.8, 0.6> rgb <0.4, 0.1, 0.2> scale 0.1 translate 0.013 }
Tile(pigment { onion color_map { Map } scale 0.2 translate 0.1 warp { repeat 0.3 * x } })
Tile(pigment { onion color_map { Map } scale 0.2 translate 0.1 warp { repeat 0.3 * x flip x offset <0, 0.1, 0> } warp { repeat 0.25 * y flip y } })
Tile(pigment { Grid warp { black_hole <0.5, 0.5, 0>, 0.45 } })
Tile(pigment { Grid warp { black_hole <0.5, 0.5, 0>, 0.4 strength 1.5 falloff 1.2 inverse } })
Tile(pigment { Grid warp { black_hole <0.15, 0.15, 0>, 0.14 repeat <0.4, 0.4, 1> turbulence <0.1, 0.1, 0> } })
Tile(pigment { gradient x color_map { Map } scale 0.3 warp { turbulence 0.3 octaves 3 omega 0.4 lambda 2.5 } })
Tile(pigment { gradient x color_map { Map } scale 0.3 warp { turbulence <0, 0.4, 0> } rotate 45 * z })
Tile(pigment { checker scale <0.1, 0.2, 1> warp { cylindrical } rotate 90 * x translate 0.5 })
Tile(pigment { checker scale <0.05, 0.05, 1> warp { spherical orientation y } translate 0.5 })
Tile(pigment { checker scale <0.1, 0.07, 1> warp { toroidal major_radius 0.3 } rotate 60 * x translate 0.5 })
Tile(pigment { checker scale <0.1, 0.13, 1> warp { cylindrical dist_exp 1 orientation z } rotate 70 * x translate 0.5 })
Tile(pigment { checker scale <0.06, 0.06, 1> translate 0.013 warp { cubic } rotate 20 translate 0.5 })
