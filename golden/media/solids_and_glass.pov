// Media in a difference and in a merge, and in glass that bends light; a solid ball in the fog keeps it out.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 2, -6> look_at <0, 0, 0> angle 42 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8 rgb 0.4 } finish { ambient 0.2 } }
plane { -z, -6 pigment { rgb <0.3, 0.4, 0.6> } finish { ambient 0.5 } }
#declare Smoke = interior { media { scattering { 1, 0.3 } absorption 0.3 samples 8 density { granite scale 2 color_map { [0 rgb 0] [0.6 rgb 2] } } } }
difference { box { <-2.2, -0.9, -0.6>, <-0.8, 0.6, 0.6> } cylinder { <-1.5, -0.2, -2>, <-1.5, -0.2, 2>, 0.4 }
  hollow pigment { rgbt 1 } interior { Smoke } }
merge { sphere { <0, -0.3, 0>, 0.55 } sphere { <0, 0.4, 0>, 0.4 } hollow pigment { rgbt 1 } interior { Smoke } }
sphere { <1.6, -0.2, 0>, 0.75 hollow pigment { rgbf 1 } finish { reflection { 0, 1 fresnel } conserve_energy specular 0.5 }
  interior { ior 1.4 media { absorption <0.9, 0.3, 0.1> emission <0, 0.02, 0.05> } } }
media { absorption 0.03 }
sphere { <0.9, 0.9, -1>, 0.3 pigment { rgbt 1 } finish { ambient 0 diffuse 0 phong 0.6 } }
