/** Numbers, vectors and matrices (manual, "Float", "Math", "Vector", "Matrix"). */
package org.urbi.kernel.library.math;
