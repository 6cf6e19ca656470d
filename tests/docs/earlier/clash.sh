printf 'o slab\nv 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' > structure.obj
printf 'o pipe\nv 1 1 0\nv 2 1 0\nv 1 2 0\nv 1 1 -3\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n' > services.obj
soms clash structure.obj --against services.obj
soms clash structure.obj services.obj --within 0.05 -o clashes.csv
soms clash structure.obj --against services.obj -o clashes.html -o clashes.bcfzip
soms clash structure.obj --against services.obj -o last-week.json
soms clash structure.obj --against services.obj --baseline last-week.json --fail-if new
soms clash structure.obj services.obj --set 'slabs=*slab*' --between slabs,services
