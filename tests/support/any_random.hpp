#pragma once
#include <concepts>
#include <cstdint>
#include <memory>
#include <rt/real.hpp>
#include <stdexcept>

namespace checkpoint {

// A source of random numbers of any type, such as one that always draws 0, as an answer gets it:
// with the calls of rt::Rng. It uses the source that it is made from; a copy of it uses a copy, as
// a copy of rt::Rng would.
class AnyRandom {
  public:
    using result_type = std::uint32_t;
    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return ~result_type{0}; }

    template <class Random>
    requires(!std::same_as<Random, AnyRandom>) explicit AnyRandom(Random& random)
        : source_{std::make_unique<Of<Random>>(random)} {}
    AnyRandom(const AnyRandom& other) : source_{other.source_->copy()} {}
    AnyRandom& operator=(const AnyRandom& other) {
        source_ = other.source_->copy();
        return *this;
    }

    rt::Real uniform() { return source_->uniform(); }
    rt::Real uniform(rt::Real low, rt::Real high) { return low + (high - low) * uniform(); }
    result_type operator()() { return source_->bits(); }

  private:
    struct Source {
        virtual ~Source() = default;
        virtual rt::Real uniform() = 0;
        virtual result_type bits() = 0;
        virtual std::unique_ptr<Source> copy() const = 0;
    };

    template <class Random>
    struct Of : Source {
        explicit Of(Random& used) : random{used} {}
        Of(std::unique_ptr<Random> made) : owned{std::move(made)}, random{*owned} {}
        rt::Real uniform() override { return random.uniform(); }
        result_type bits() override {
            if constexpr (requires { random(); }) return random();
            throw std::logic_error("draw your random numbers by random.uniform()");
        }
        std::unique_ptr<Source> copy() const override {
            return std::make_unique<Of>(std::make_unique<Random>(random));
        }
        std::unique_ptr<Random> owned;
        Random& random;
    };

    std::unique_ptr<Source> source_;
};

}  // namespace checkpoint
