/** Where time comes from; nobody else may read a clock. */
package org.urbi.kernel.time;
