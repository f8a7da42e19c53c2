// Two media in one interior, and a ball of a third inside: the master's intervals count for both.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -4> look_at 0 angle 45 }
background { rgb 0.2 }
plane { -z, -3 pigment { gradient x color_map { [0 rgb 0.2] [1 rgb 0.5] } scale 0.7 } finish { ambient 1 diffuse 0 } }
light_source { <-3, 4, -3> rgb 1 }
box { -1, 1 hollow pigment { rgbt 1 } rotate <10, 25, 0>
  interior {
    media { emission <0.02, 0.1, 0.2> samples 5 density { wood color_map { [0 rgb 0] [0.5 rgb 2] } turbulence 0.1 scale 0.4 } }
    media { scattering { 5, 0.3 eccentricity 0.4 } intervals 3 samples 6 aa_threshold 0.05 }
  } }
sphere { <0.1, 0, 0>, 0.6 hollow pigment { rgbt 1 } interior { media { absorption <0.2, 1, 2> emission <0.4, 0.1, 0> } } }
