// max needs commas between its arguments.
#declare Largest = max(1 2 3);
sphere { 0, Largest }
