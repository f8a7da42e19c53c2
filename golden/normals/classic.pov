// The normals with formulas of their own: bumps, dents, wrinkles, quilted, ripples, waves; amounts, scales, noise generators.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
light_source { <-7, 9, -5> rgb 1.3 }
background { rgb <0.1, 0.12, 0.2> }
#default { pigment { rgb <0.9, 0.85, 0.8> } finish { ambient 0 diffuse 0.8 } }
#declare N = 0;
#macro Tile(B) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> normal { B } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

Tile(normal { bumps 0.6 scale 0.1 })
Tile(normal { dents 1.2 scale 0.1 })
Tile(normal { wrinkles 0.7 scale 0.2 })
Tile(normal { quilted 0.7 scale 0.2 })
Tile(normal { ripples 0.6 scale 0.1 })
Tile(normal { waves 0.6 scale 0.1 })
Tile(normal { bumps 0.6 scale <0.3, 0.05, 0.1> rotate 30 * z })
Tile(normal { dents 1.2 noise_generator 1 scale 0.1 })
Tile(normal { quilted 0.9 control0 0.2 control1 0.4 scale 0.25 rotate 20 })
Tile(normal { ripples 0.5 frequency 3 phase 0.3 scale 0.2 })
Tile(normal { waves 0.5 frequency 2 scale 0.1 })
Tile(normal { bumps -0.5 turbulence 0.4 scale 0.15 })
