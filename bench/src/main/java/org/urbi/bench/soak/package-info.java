/** A server that many clients come to, use, misuse and leave, for a long time. */
package org.urbi.bench.soak;
