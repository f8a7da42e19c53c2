// A spline without a single point.
#declare S = spline { linear_spline }
