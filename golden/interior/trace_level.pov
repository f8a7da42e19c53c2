// max_trace_level and adc_bailout: mirrors face to face stop after a few reflections.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 adc_bailout 0.05 }

camera { location <0.4, 0.3, -3> look_at <0, 0, 1> angle 65 }
light_source { <0, 1.5, -1> rgb 1 }
plane { x, -1.5 pigment { rgb <0.3, 0.1, 0.1> } finish { reflection 0.7 } }
plane { -x, -1.5 pigment { rgb <0.1, 0.1, 0.3> } finish { reflection 0.7 } }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.2 scale 0.5 translate <0.1, 0.1, 0.1> } }
plane { -z, -4 pigment { rgb <0.4, 0.5, 0.4> } }
sphere { <0, -0.3, 1>, 0.6 pigment { rgbf <0.9, 0.9, 1, 0.8> } interior { ior 1.4 } finish { reflection 0.2 } }
