/** Numbers, vectors and matrices (manual, "Float", "Math", "Vector", "Matrix"). */
@NullMarked
package org.urbi.kernel.library.math;

import org.jspecify.annotations.NullMarked;
