// A spotlight and a tube of light seen in the air of a room; the spotlight is partly blocked.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at <0, 1.2, 0> angle 55 }
media { scattering { 1, 0.08 extinction 0.5 } intervals 6 samples 8 ratio 0.8 }
plane { y, 0 pigment { rgb <0.7, 0.6, 0.5> } finish { ambient 0.1 } }
plane { -z, -3 pigment { rgb <0.3, 0.4, 0.6> } finish { ambient 0.1 } }
sphere { <-0.6, 1.2, 0>, 0.35 pigment { rgb <0.9, 0.3, 0.2> } }
light_source { <-2.5, 4, -0.5> rgb <3, 2.6, 2> spotlight point_at <0, 0, 0.2> radius 12 falloff 18 fade_distance 4 fade_power 1 }
light_source { <3.2, 2.4, 0.5> rgb <0.4, 0.9, 1.4> cylinder point_at <-1, 0.3, 1> radius 0.25 falloff 0.4 }
