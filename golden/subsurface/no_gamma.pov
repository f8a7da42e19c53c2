// No version and no gamma: values are those that a file shows.
global_settings { subsurface { samples 150, 40 } mm_per_unit 20 }
camera { location <0, 1, -5> look_at 0 right 4/3*x up y angle 40 }
light_source { <-5, 6, -4>, rgb 0.8 }
plane { y, -0.8 pigment { checker rgb 0.4 rgb 0.6 } }
sphere { <-0.9, 0, 0>, 0.8 pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse 0.8 subsurface { translucency 1.5 } } interior { ior 1.3 } }
sphere { <0.9, 0, 0>, 0.8 pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse 0.8 } }
