// Thin leaves before a wall: what is behind shows straight through them, bent twice; no light goes into them.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 subsurface { samples 100, 40 } }
camera { location <0, 1.5, -5> look_at 0 right 4/3*x up y angle 40 }
plane { -z, -3 pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.2, 0.4, 0.8> scale 0.4 } finish { ambient 0.9 diffuse 0 } }
#declare Leaf = texture { pigment { rgb <0.9, 0.9, 0.8> } finish { ambient 0 diffuse 0.8 subsurface { translucency <2, 1.5, 1> } } }
box { <-1.6, -1, 0>, <0.2, 1, 0.08> texture { Leaf } interior { ior 1.5 } rotate 20*y }
box { <-0.4, -0.6, -0.6>, <1.5, 0.9, -0.55> texture { Leaf } interior { ior 1.5 } rotate -15*y }
box { <-0.9, -0.8, -1.2>, <0.6, 0.2, -1.17> texture { Leaf } interior { ior 1.5 } }
