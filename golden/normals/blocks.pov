// Block patterns as normals, image based bumps, facets.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
light_source { <-7, 9, -5> rgb 1.3 }
background { rgb <0.1, 0.12, 0.2> }
#default { pigment { rgb <0.9, 0.85, 0.8> } finish { ambient 0 diffuse 0.8 } }
#declare N = 0;
#macro Tile(B) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> normal { B } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

Tile(normal { checker 1.6 accuracy 0.15 scale 0.23 translate 0.013 })
Tile(normal { brick 1.6 accuracy 0.3 scale 0.04 translate 0.013 })
Tile(normal { hexagon 1.2 accuracy 0.1 scale 0.2 rotate 70 * x })
Tile(normal { cells 2 accuracy 0.1 scale 0.2 translate 0.013 })
Tile(normal { facets size 0.6 scale 0.3 })
Tile(normal { facets coords 0.6 size 0.1 })
Tile(normal { checker normal { bumps 0.6 scale 0.2 } normal { onion 0.5 scale 0.2 } scale 0.3 translate 0.013 })
Tile(normal { bump_map { function 16, 16 { x * y } interpolate 2 bump_size 4 } })
Tile(normal { bump_map { function 16, 16 { 0.5 + 0.5 * sin(x * 20) * sin(y * 20) } bump_size 2 } scale 0.5 })
Tile(normal { quilted bump_size 1.6 scale 0.3 })
Tile(normal { tiling 8, 1.6 scale 0.2 rotate 80 * x })
Tile(normal { brick normal { granite 0.2 scale 0.3 } normal { dents 0.6 scale 0.1 } scale 0.05 translate 0.013 })
