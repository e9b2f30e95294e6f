/** Small benchmarks for JMH: what one thing costs. */
package org.urbi.bench.jmh;
