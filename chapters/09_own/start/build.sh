g++ -std=c++20 -O3 -march=native -pthread ${MSYSTEM:+-Wa,-muse-unaligned-vector-move} main.cpp -o own "$@"
