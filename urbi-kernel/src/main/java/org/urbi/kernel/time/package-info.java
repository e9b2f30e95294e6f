/** Where time comes from; nobody else may read a clock. */
@NullMarked
package org.urbi.kernel.time;

import org.jspecify.annotations.NullMarked;
