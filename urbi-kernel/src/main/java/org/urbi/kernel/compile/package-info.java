/** From the syntax tree to executable nodes. */
package org.urbi.kernel.compile;
