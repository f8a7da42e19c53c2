// The index of a finish is that of its object's interior, also for a camera in it; of those who share an interior,
// whoever comes last decides, and interior textures have no say.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -4> look_at 0 angle 40 }
plane { z, 5 hollow pigment { checker rgb <0.9, 0.9, 0.4>, rgb <0.2, 0.3, 0.7> scale 0.7 } finish { ambient 1 diffuse 0 } }
#default { pigment { rgbt <1, 0.9, 0.9, 1> } finish { ambient 0 diffuse 0 } }
#declare Slow = texture { finish { ior 1.2 } }
#declare Fast = texture { finish { ior 0 } }
sphere { <0.3, 0.2, -4>, 1 texture { finish { ior 1.1 } } interior { ior 1.5 } hollow }
union { sphere { 0, 0.4 texture { Slow } } sphere { 0.3 * x, 0.3 texture { finish { ior -1 } } } interior { ior 1.5 } translate <-0.9, 0.6, 0> }
union { sphere { 0, 0.4 texture { Slow } } sphere { 0.3 * x, 0.3 texture { Fast } } interior { ior 1.5 } translate <0.7, 0.6, 0> }
intersection { sphere { 0, 0.5 } sphere { 0.3 * x, 0.5 texture { finish { ior 1.3 } } } texture { Slow } interior { ior 1.8 } translate <-0.9, -0.6, 0> }
sphere { <0.3, -0.6, 0>, 0.4 texture { pigment { rgbt 1 } } interior_texture { Slow } interior { ior 1.4 } }
