//! Chains of posts through those of the plain print, which look for others only where one is missing.

use crate::geometry::curve::Curve;
use crate::head::Head;
use crate::wireframe::place::chain::Chain;
use crate::wireframe::place::posts::{Candidate, Post, PostParams};

/// The cheapest chain through all posts of the plain print among the candidates; None where there
/// are none. The first candidate of a closed curve is one of them.
#[must_use]
pub fn place_through(
    curve: &Curve,
    start: f64,
    all: &[Candidate],
    head: &Head,
    p: &PostParams,
) -> Option<Vec<Post>> {
    let kept: Vec<usize> = (0..all.len()).filter(|&i| all[i].kept.is_some()).collect();
    let (&first, &last) = (kept.first()?, kept.last()?);
    let part = |from: usize, to: usize| Chain::new(curve, start, &all[from..=to], head, p);
    let mut posts = if curve.is_closed() { Vec::new() } else { leading_up(&part, all, first, p) };
    posts.push(all[first].post);
    for pair in kept.windows(2) {
        posts.extend(between(&part(pair[0], pair[1]), pair[1] - pair[0]));
        posts.push(all[pair[1]].post);
    }
    posts.extend(leading_on(&part(last, all.len() - 1), all.len() - last, &all[first]));
    Some(posts)
}

/// The posts before the first one of the plain print on an open curve.
fn leading_up<'a>(
    part: &impl Fn(usize, usize) -> Chain<'a>,
    all: &[Candidate],
    first: usize,
    p: &PostParams,
) -> Vec<Post> {
    let open = |i: usize| (all[i].post.s / p.ideal).powi(2);
    let mut best = (open(first), Vec::new());
    for i in 0..first {
        let chain = part(i, first);
        let (costs, before) = chain.chains(f64::INFINITY);
        let cost = costs[first - i] + open(i);
        if cost < best.0 {
            let mut posts = chain.way(&before, first - i);
            posts.pop();
            best = (cost, posts);
        }
    }
    best.1
}

/// The posts between the first of some candidates and the last, both of the plain print.
fn between(chain: &Chain, last: usize) -> Vec<Post> {
    let (costs, before) = chain.chains(f64::INFINITY);
    if costs[last].is_infinite() {
        return Vec::new();
    }
    let posts = chain.way(&before, last);
    posts[1..posts.len() - 1].to_vec()
}

/// The posts after the last one of the plain print, up to the curve's end, or back to `home`.
fn leading_on(chain: &Chain, count: usize, home: &Candidate) -> Vec<Post> {
    let (costs, before) = chain.chains(f64::INFINITY);
    let cost = |j: usize| chain.closing(j, home, f64::INFINITY).map(|rest| (costs[j] + rest, j));
    let best = (0..count).filter_map(cost).min_by(|a, b| a.0.total_cmp(&b.0));
    best.map_or_else(Vec::new, |(_, end)| chain.way(&before, end)[1..].to_vec())
}

#[cfg(test)]
mod tests;
