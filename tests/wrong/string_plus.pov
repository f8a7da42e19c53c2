// Strings joined by a plus sign.
#version 3.7;
#declare N = 3;
#declare Name = "frame" + str(N, 0, 0);
#debug Name
