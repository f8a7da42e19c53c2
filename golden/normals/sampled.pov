// Normals from the slopes of other patterns: the sampled pyramid, accuracy, frequency and waves.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
light_source { <-7, 9, -5> rgb 1.3 }
background { rgb <0.1, 0.12, 0.2> }
#default { pigment { rgb <0.9, 0.85, 0.8> } finish { ambient 0 diffuse 0.8 } }
#declare N = 0;
#macro Tile(B) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> normal { B } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

Tile(normal { onion 2.4 scale 0.2 translate 0.4 })
Tile(normal { wood 2 scale 0.2 translate 0.4 })
Tile(normal { marble 2 turbulence 0.3 scale 0.2 })
Tile(normal { leopard 2.8 scale 0.05 })
Tile(normal { granite 1.2 scale 0.4 })
Tile(normal { crackle 2.8 scale 0.2 })
Tile(normal { gradient x, 1.6 sine_wave frequency 3 })
Tile(normal { radial 2.4 sine_wave frequency 6 rotate 90 * x translate 0.5 })
Tile(normal { spiral1 3, 2 scale 0.3 translate 0.5 })
Tile(normal { agate 1.6 scale 0.3 })
Tile(normal { spherical 3.2 scale 0.5 translate 0.5 })
Tile(normal { function { sin(x * 30) * 0.3 } 0.5 accuracy 0.001 })
