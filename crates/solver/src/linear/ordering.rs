//! Elimination order of the blocks: minimum degree on the graph of blocks.
//!
//! A multiplier block has nothing on its diagonal until the velocity blocks it touches are gone;
//! it then holds `-B M^-1 B^T`, which is definite. So it may only be eliminated after them, and no
//! pivoting across blocks is needed. Among equals the later block goes first: models are numbered
//! from their fixed end, and eliminating from the free end keeps the pivots stiff.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::Pattern;

/// Order of elimination and, for each step, the blocks that are still coupled to it.
pub struct Order {
    /// Block eliminated at each step.
    pub blocks: Vec<usize>,
    /// Step at which each block is eliminated.
    pub step_of: Vec<usize>,
    /// For each step, the later steps coupled to it, ascending, fill included.
    pub coupled: Vec<Vec<usize>>,
}

/// Neighbours of each block, sorted, without the block itself.
pub fn neighbours(pattern: &Pattern) -> Vec<Vec<usize>> {
    let mut graph = vec![Vec::new(); pattern.sizes.len()];
    for &(row, column) in &pattern.pairs {
        if row != column && row < graph.len() && column < graph.len() {
            graph[row].push(column);
            graph[column].push(row);
        }
    }
    for list in &mut graph {
        list.sort_unstable();
        list.dedup();
    }
    graph
}

/// Minimum degree, degrees counted in scalar unknowns.
pub fn minimum_degree(pattern: &Pattern) -> Order {
    let original = neighbours(pattern);
    let mut graph = original.clone();
    let count = graph.len();
    let is_velocity = |block: usize| block < pattern.velocity_blocks;
    let degree = |list: &[usize]| list.iter().map(|&b| pattern.sizes[b]).sum::<usize>();
    let mut waiting: Vec<usize> = (0..count)
        .map(|b| if is_velocity(b) { 0 } else { graph[b].iter().filter(|&&n| is_velocity(n)).count() })
        .collect();
    let mut current: Vec<usize> = graph.iter().map(|list| degree(list)).collect();
    let mut queue: BinaryHeap<(Reverse<usize>, usize)> =
        (0..count).filter(|&b| waiting[b] == 0).map(|b| (Reverse(current[b]), b)).collect();
    let mut step_of = vec![usize::MAX; count];
    let mut blocks = Vec::with_capacity(count);
    let mut coupled = Vec::with_capacity(count);
    let mut merged = Vec::new();
    while let Some((Reverse(recorded), block)) = queue.pop() {
        if step_of[block] != usize::MAX || recorded != current[block] {
            continue;
        }
        step_of[block] = blocks.len();
        blocks.push(block);
        let clique = std::mem::take(&mut graph[block]);
        for &other in &clique {
            // Union of two sorted lists without `block` and `other`.
            merged.clear();
            let (mut a, mut b) = (graph[other].iter().copied().peekable(), clique.iter().copied().peekable());
            loop {
                let next = match (a.peek(), b.peek()) {
                    (Some(&x), Some(&y)) if x == y => {
                        b.next();
                        a.next()
                    }
                    (Some(&x), Some(&y)) if x < y => a.next(),
                    (Some(_), None) => a.next(),
                    (_, Some(_)) => b.next(),
                    (None, None) => break,
                };
                match next {
                    Some(x) if x != block && x != other => merged.push(x),
                    _ => {}
                }
            }
            graph[other].clear();
            graph[other].extend_from_slice(&merged);
            current[other] = degree(&graph[other]);
            // Only the multiplier's own `B` counts, not fill between it and other velocities.
            if !is_velocity(other) && is_velocity(block) && original[other].binary_search(&block).is_ok() {
                waiting[other] -= 1;
            }
            if waiting[other] == 0 {
                queue.push((Reverse(current[other]), other));
            }
        }
        coupled.push(clique);
    }
    for list in &mut coupled {
        for block in list.iter_mut() {
            *block = step_of[*block];
        }
        list.sort_unstable();
    }
    Order { blocks, step_of, coupled }
}
