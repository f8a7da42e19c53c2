// A smoky box throws a soft shadow; light from its side scatters in it by the hazy and the Rayleigh phase function.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -5> look_at <0, 0.6, 0> angle 45 }
light_source { <6, 5, -2> rgb 1.2 }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.8 } }
box { <-1.6, 0.1, -0.7>, <-0.2, 1.5, 0.7> hollow pigment { rgbt 1 }
  interior { media { scattering { 2, <0.5, 0.6, 0.8> } absorption 0.2
    density { planar color_map { [0 rgb 0.2] [1 rgb 2] } scale 1.4 translate 0.1*y } intervals 2 samples 12 } } }
box { <0.2, 0.1, -0.7>, <1.6, 1.5, 0.7> hollow pigment { rgbf <1, 0.9, 0.8, 1> }
  interior { media { scattering { 4, 0.4 } samples 6 } } }
