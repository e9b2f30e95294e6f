/** Small benchmarks for JMH: what one thing costs. */
@NullMarked
package org.urbi.bench.jmh;

import org.jspecify.annotations.NullMarked;
