// Tables to begin with. Their numbers were drawn from the law with errors, and rounded as they would
// be read; one wall is rough, one protractor turned.

export const EXAMPLES = [
  {
    title: "A wall: ten angles",
    angle_error: "1",
    data: `alpha\tbeta
19\t13
25\t18
31\t22
34\t25
41\t32
45\t34
49\t41
55\t43
60\t49
64\t56`,
  },
  {
    title: "A rough wall, with speeds",
    angle_error: "1",
    data: `alpha\tbeta\tu (m/s)\tv (m/s)
24\t20\t2.06\t1.80
31\t22\t2.07\t1.77
34\t28\t1.69\t1.40
40\t31\t1.52\t1.22
46\t38\t1.44\t1.14
50\t42\t1.43\t1.15
56\t46\t1.53\t1.24
59\t54\t1.51\t1.15
66\t59\t1.42\t1.14`,
  },
  {
    title: "A protractor held askew",
    angle_error: "1",
    data: `alpha\tbeta
26\t9
31\t14
36\t17
41\t22
45\t27
50\t30
55\t37
61\t40
65\t47
70\t51`,
  },
  {
    title: "Two spheres, B at rest",
    data: `m_A (g)\tm_B (g)\tu_A_x\tu_A_y\tv_A_x\tv_A_y\tv_B_x\tv_B_y
50\t50\t1.36\t0.00\t0.25\t-0.41\t1.12\t0.42
50\t50\t1.33\t-0.02\t0.41\t0.54\t0.94\t-0.54
50\t50\t0.74\t-0.01\t0.35\t-0.35\t0.41\t0.36
50\t50\t1.07\t0.02\t0.12\t-0.18\t0.98\t0.17
50\t50\t0.83\t-0.01\t0.45\t0.40\t0.38\t-0.38
50\t50\t1.29\t0.00\t0.31\t-0.47\t0.98\t0.46`,
  },
];
