#pragma once

namespace rt {

// The two ways to find the light of a lamp (given): a sample of the lamp, or a bounce that happens
// to meet it.
enum class Way { sample, bounce };

// Which of them count, and how (given): only samples, only bounces, or both, with the weights of
// the balance heuristic or of the power heuristic.
enum class Ways { samples, bounces, balance, power };

}  // namespace rt
