g++ -std=c++20 -O3 -march=native -pthread main.cpp -o own "$@"
