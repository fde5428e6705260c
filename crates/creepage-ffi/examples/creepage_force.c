/*
 * Forces of a measured history from GNU Octave and MATLAB, as a MEX function:
 *
 *   mex -I$PREFIX/include creepage_force.c -L$PREFIX/lib -lcreepage_ffi
 *
 *   [forces, statuses] = creepage_force('case.toml', 'fastsim', 'longitudinal,normal_force', values)
 *
 * values has a row for each quantity and a column for each case; forces has the rows longitudinal
 * (N), lateral (N), moment (N m). An empty theory is the file's own.
 */
#include "creepage.h"
#include "mex.h"

/* How many names a text with commas has. */
static mwSize names(const char *text)
{
    mwSize count = 1;
    for (; *text; text++)
        count += *text == ',';
    return count;
}

static void stop(int32_t code, const char *message)
{
    if (code != CREEPAGE_OK)
        mexErrMsgIdAndTxt("creepage:failed", "%s", message);
}

void mexFunction(int outputs, mxArray *out[], int inputs, const mxArray *in[])
{
    char message[512], *path, *theory, *quantities;
    CreepageCase *made;
    int32_t code;
    mwSize count;
    mxArray *statuses;

    if (inputs != 4 || !mxIsChar(in[0]) || !mxIsChar(in[1]) || !mxIsChar(in[2]) || !mxIsDouble(in[3]))
        mexErrMsgIdAndTxt("creepage:usage", "creepage_force(case, theory, quantities, values)");
    path = mxArrayToString(in[0]);
    theory = mxArrayToString(in[1]);
    quantities = mxArrayToString(in[2]);
    count = mxGetN(in[3]);
    if (mxGetM(in[3]) != names(quantities))
        mexErrMsgIdAndTxt("creepage:usage", "values must have a row for each quantity");
    out[0] = mxCreateDoubleMatrix(3, count, mxREAL);
    statuses = mxCreateNumericMatrix(1, count, mxINT32_CLASS, mxREAL);
    code = creepage_case_new(path, theory[0] ? theory : NULL, &made, message, sizeof message);
    if (code == CREEPAGE_OK) {
        code = creepage_case_force(made, NULL, quantities, count, mxGetPr(in[3]), mxGetPr(out[0]), NULL,
                                   NULL, NULL, mxGetData(statuses), message, sizeof message);
        creepage_case_free(made);
    }
    mxFree(path);
    mxFree(theory);
    mxFree(quantities);
    if (outputs > 1)
        out[1] = statuses;
    else
        mxDestroyArray(statuses);
    stop(code, message);
}
